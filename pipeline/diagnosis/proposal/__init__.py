"""The run to record next: what parts the explanations that tie, and what each foretells of it."""
