"""Questions of a table → answers with intervals, or the reason why there is none."""
