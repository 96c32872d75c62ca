"""One string over several runs: their order, its common tare, and what the zero did in between."""
