"""Recordings as a diagnosis works on them: samples without spikes, what they cover, what may drive an effect."""
