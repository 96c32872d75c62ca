"""One string over several runs: their order, their common tare, and the changes of the zero between them."""
