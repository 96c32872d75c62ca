"""What a recording or its description says that can hardly be: questions, and refusals, before it is used."""
