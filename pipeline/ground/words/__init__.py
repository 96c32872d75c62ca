"""Words that several programs use: counts, progress, notes of left-out runs, the glossary."""
