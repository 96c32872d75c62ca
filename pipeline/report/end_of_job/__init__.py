"""The end of the main job: its summary, its failures, and the removal of stale reports."""
