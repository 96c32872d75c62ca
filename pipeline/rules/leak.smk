from pipeline.ground.model_names import PAPER

LEAKING = {
    "random_forward": {"composite": "random", "loss": "forward"},
    "random_both": {"composite": "random", "loss": "both"},
    "identity_forward": {"composite": "identity", "loss": "forward"},
}
LEAK_SEEDS = range(config["leak"]["seeds"])
LEAK_FIGURES = expand(
    "reports/{material}/figure_leak.{suffix}",
    material=[material for material in MATERIALS if material == config["leak"]["material"]],
    suffix=["png", "pdf"],
)


def settings_of_leaking(wildcards):
    own = {**LEAKING[wildcards.variant], "permutation_seed": int(wildcards.seed)}
    return json.dumps({**config["models"][PAPER]["settings"], **config["leak"]["settings"], **own}, sort_keys=True)


rule train_leak:
    input:
        "processed/{material}/dataset.parquet",
    output:
        predictions="processed/{material}/leak/{variant}/within-{seed}.predictions.parquet",
        model="processed/{material}/leak/{variant}/within-{seed}.model",
    log:
        "processed/logs/train_leak-{material}-{variant}-{seed}.log",
    wildcard_constraints:
        variant="|".join(LEAKING),
    threads: 1
    resources:
        **NEEDS["train_leak"],
    params:
        model=PAPER,
        settings=settings_of_leaking,
        code=fingerprint("pipeline.stages.train", f"pipeline.models.{PAPER}"),
    message:
        "train the INN on {wildcards.material} as {wildcards.variant}, permutation {wildcards.seed}"
    shell:
        "exec python -m pipeline.stages.train {input:q} --model {params.model:q} --split within --seed {wildcards.seed:q}"
        " --settings {params.settings:q} --out-model {output.model:q} --out-predictions {output.predictions:q}"
        " > {log:q} 2>&1"


rule leak:
    input:
        dataset="processed/{material}/dataset.parquet",
        variants=expand("processed/{{material}}/leak/{variant}/within-{seed}.model", variant=LEAKING, seed=LEAK_SEEDS),
        tabled=expand(
            "processed/{{material}}/{model}/within-{seed}.model",
            model=PAPER,
            seed=range(config["models"][PAPER]["seeds"]["within"]),
        ),
    output:
        "processed/{material}/leak/leak.parquet",
    log:
        "processed/logs/leak-{material}.log",
    resources:
        **NEEDS["leak"],
    params:
        code=fingerprint("pipeline.stages.leak"),
    message:
        "take the INN's inverse errors on {wildcards.material} apart"
    shell:
        "exec python -m pipeline.stages.leak {input.dataset:q} {input.variants:q} {input.tabled:q} --out {output:q} > {log:q} 2>&1"


rule leak_figure:
    input:
        leak="processed/{material}/leak/leak.parquet",
        metrics="processed/{material}/metrics.parquet",
    output:
        expand("reports/{{material}}/figure_leak.{suffix}", suffix=["png", "pdf"]),
    log:
        "processed/logs/leak_figure-{material}.log",
    resources:
        **NEEDS["leak_figure"],
    params:
        made_by=MARK_OF_ALL,
        code=fingerprint("pipeline.report.leak"),
    message:
        "draw what forward-only training does to the INN's inverse on {wildcards.material}"
    shell:
        "exec python -m pipeline.report.leak {input.leak:q} {input.metrics:q} --made-by {params.made_by:q}"
        " --out-dir reports/{wildcards.material:q} > {log:q} 2>&1"
