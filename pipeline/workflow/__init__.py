"""The plan of the files to make, for the Snakefile, and the memory of files from earlier starts."""
