"""What a person reads in one piece: `verdict.txt`, `details.txt`, and the sections that stand on no other page."""
