"""Mathematics that knows no rig: recursions, noise, least squares between bounds, the judge's logit."""
