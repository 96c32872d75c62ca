from functools import cache


def settings(wildcards):
    return json.dumps(config["models"][wildcards.model]["settings"], sort_keys=True)


# Once a model, not once a fit: of a thousand runs there are two thousand fits, and a fingerprint reads some sixty files.
@cache
def code_of_training(model):
    return fingerprint("pipeline.stages.train", f"pipeline.models.{model}")


def code_of_model(wildcards):
    return code_of_training(wildcards.model)


rule train:
    input:
        "processed/{material}/dataset.parquet",
    output:
        predictions="processed/{material}/{model}/{split}-{seed}.predictions.parquet",
        model="processed/{material}/{model}/{split}-{seed}.model",
    log:
        "processed/logs/train-{material}-{model}-{split}-{seed}.log",
    benchmark:
        "processed/logs/train-{material}-{model}-{split}-{seed}.tsv"
    threads: 1
    resources:
        **NEEDS["train"],
    params:
        settings=settings,
        code=code_of_model,
    message:
        "train {wildcards.model} on {wildcards.material}, split {wildcards.split}, seed {wildcards.seed}"
    shell:
        "exec python -m pipeline.stages.train {input:q} --model {wildcards.model:q} --split {wildcards.split:q}"
        " --seed {wildcards.seed:q} --settings {params.settings:q}"
        " --out-model {output.model:q} --out-predictions {output.predictions:q} > {log:q} 2>&1"
