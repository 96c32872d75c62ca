"""The measured dimensions in `run.yaml`: which ones moved, and how to measure them again."""
