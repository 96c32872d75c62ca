"""The pages of the public recordings: every rig, and all of them together."""
