"""The diagnosis as a model: its problem of training points, and its simulator along a motion."""
