"""Opening the answers and scoring the verdicts: files in, tables and figures out, and neither rig nor diagnosis."""
