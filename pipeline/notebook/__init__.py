"""twistbench in memory, for a notebook or a program of one's own: recordings, models, diagnoses, without a folder."""
