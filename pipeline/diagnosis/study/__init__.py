"""One pass over a recording, from calibration to the verdict, repeated where strokes are held out."""
