"""How often forecasts held on whole lives of strings, beside simple peers."""
