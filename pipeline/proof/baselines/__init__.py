"""Other methods on the same recordings, one file each; the diagnosis is scored beside them."""
