"""Storage that is read again: whole files and folders, tables with a check sum, figures."""
