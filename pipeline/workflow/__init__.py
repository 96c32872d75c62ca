"""What there is to make: the plan that the Snakefile asks, and what is known of the files of an earlier start."""
