"""Metrics and predictions → what a person reads: tables, comparison, figures. Stands on files, not on models."""
