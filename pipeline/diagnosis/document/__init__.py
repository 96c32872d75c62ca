"""The form in which `diagnosis.json` and `run.yaml` hold a diagnosis, and its check before a program reads it."""
