"""The loop that settles a tie: propose a run, have it approved, record it, diagnose all together, until one is left."""
