"""Where simulation and recording differ, which physics was left out, and how much better the fit gets with it.

A room imports only rooms that stand above it in this picture; what ties them together stands at this level.

    document    numerics            what diagnosis.json holds · mathematics that knows no rig
          recording                 a run → samples without spikes, and what may drive an effect
         mechanisms                 the library: a file for each piece of physics
             fit                    a recording with its simulator → dimensions, effects, intervals
           choice                   candidates → search → how likely each explanation is → the verdict
        study    facts              the whole pass, also with strokes held out · sizes, places, loops, look-alikes
    proposal    prediction          the run to record next · the improved simulator alone
            words                   every sentence, from the content of diagnosis.json
      drawing    adoption           the page of figures · what was found, in run.yaml

`in_memory` goes from recordings to the content of diagnosis.json, which `verdict` puts together; `written` writes it.
"""
