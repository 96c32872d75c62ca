"""Opens the answers and scores the verdicts: it reads files and writes tables and figures, without rig or diagnosis."""
