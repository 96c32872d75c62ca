"""Which mechanisms explain a recording: candidates, search, how likely each explanation is, and the verdict."""
