# The only runs that a rule may make: those that the pipeline records itself, on the synthetic rig.
rule record:
    output:
        expand("raw/{{run}}/{file}", file=SYNTHETIC_FILES),
    log:
        "processed/logs/record-{run}.log",
    wildcard_constraints:
        run="|".join(SYNTHETIC) or "$",
    resources:
        **NEEDS["record"],
    params:
        setup=lookup("synthetic/{run}/setup", within=config),
        seed=lookup("synthetic/{run}/seed", within=config),
        code=fingerprint("pipeline.rig.*", "pipeline.capture"),
    message:
        "record {wildcards.run} on the synthetic rig"
    shell:
        "exec python -m pipeline.rig.record {params.setup:q} raw/{wildcards.run:q} --seed {params.seed:q} > {log:q} 2>&1"
