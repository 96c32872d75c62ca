"""Where simulation and recording part, which physics was left out, and how much better the fit gets with it."""
