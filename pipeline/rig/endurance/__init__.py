"""Synthetic strings that are worked until they fail, or until the recording ends, with the truth of every stroke.

Its effects are of its own, beside the rig's: what ages over hundreds of strokes shows nothing in a short recording.
"""
