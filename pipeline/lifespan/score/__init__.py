"""How often forecasts held over whole lives of strings, beside simple peers."""
