"""Kinematic models of a twisted string: one file a model, one interface."""
