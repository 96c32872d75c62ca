"""Questions of a table → answers with intervals, or why there is none."""
