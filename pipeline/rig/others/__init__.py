"""Recordings of two rigs without a string, made with concealed effects: a cable drive and a moving mass."""
