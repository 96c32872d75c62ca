"""Words of a diagnosis: every sentence and protocol is made here, from the content of `diagnosis.json`."""
