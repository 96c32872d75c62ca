"""What is written and read again: whole files and folders, tables with a check sum, figures."""
