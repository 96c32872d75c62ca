"""Metrics and predictions → pages for a person: tables, comparison, figures. It reads files, and no models."""
