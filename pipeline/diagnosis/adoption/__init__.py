"""What run.yaml takes over from a diagnosis, and how far the simulator is off before and after."""
