"""What importing a foreign recording needs beside the readers: its clock mended, its axes parted, a mapping drafted."""
