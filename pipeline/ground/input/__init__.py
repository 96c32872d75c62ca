"""Input from a person: YAML, names of columns, a command line, and its refusal."""
