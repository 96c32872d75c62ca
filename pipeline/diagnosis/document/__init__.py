"""What `diagnosis.json` and `run.yaml` hold of a diagnosis, and that it has the form for a program to read."""
