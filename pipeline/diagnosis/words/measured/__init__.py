"""What was measured on the rig and stands in `run.yaml`: which dimensions moved, and how to measure them again."""
