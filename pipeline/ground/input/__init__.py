"""What a person gives: YAML, names of columns, a command line, and where it is refused."""
