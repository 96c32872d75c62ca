"""What programs say in more than one place: counts, progress, notes of what was left out, the glossary."""
