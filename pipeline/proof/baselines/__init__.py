"""What others would do with the same recordings: methods beside which the diagnosis is scored, one file each."""
