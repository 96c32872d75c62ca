"""What the main job does and says at its end: the summary, what failed, and stale reports that go."""
