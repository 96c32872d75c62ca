"""The run to make next: what it tells, whether it is worth making, its steps and its commands."""
