#!/bin/sh
# Computes an experiment on a Slurm cluster: an array job of shares, then a merge that waits for it.
#
#   experiments/slurm.sh EXPERIMENT.toml SHARES [OUT]
#
# OUT (default: inkbench-out/NAME of the file) becomes the run folder; the shares are in
# OUT.parts/I-of-SHARES until then, and logs beside them. The folder must be one that all nodes see.
#
# A share that failed or was killed goes on where it was: TASKS=3,7 experiments/slurm.sh ... submits
# shares 3 and 7 again, and a new merge. The number of shares stays that of the first time: a single
# task that is submitted again counts as an array of one, so it must be told.
#
# Environment: INKBENCH the program (default: build/release/inkbench), INKBENCH_ARGS more arguments of
# `inkbench run`, SBATCH_ARGS more arguments of sbatch for the shares (such as "-c 2 --mem=4G"),
# TASKS the shares to submit (default: all).
set -eu

if [ $# -lt 2 ] || [ $# -gt 3 ]; then
    sed -n '2,/^set/s/^# \{0,1\}//p' "$0" | sed '$d' >&2
    exit 2
fi
file=$1
shares=$2
case $shares in '' | *[!0-9]* | 0)
    echo "slurm.sh: '$shares' is no number of shares (accepted: 1 or more)" >&2
    exit 2
    ;;
esac
[ -f "$file" ] || { echo "slurm.sh: there is no file $file (accepted: an experiment's TOML file)" >&2; exit 2; }
command -v sbatch >/dev/null || { echo "slurm.sh: there is no sbatch here (Debian: slurm-client)" >&2; exit 2; }
out=${3:-inkbench-out/$(basename "$file" .toml)}
program=${INKBENCH:-build/release/inkbench}
parts=$out.parts
mkdir -p "$parts"

# shellcheck disable=SC2086 # the arguments are words
job=$(sbatch --parsable --job-name="inkbench-$(basename "$file" .toml)" \
    --array="${TASKS:-1-$shares}" --output="$parts/%a.log" --open-mode=append ${SBATCH_ARGS:-} \
    --wrap "exec '$program' run '$file' --quiet --shard \$SLURM_ARRAY_TASK_ID/$shares \
--out '$parts'/\$SLURM_ARRAY_TASK_ID-of-$shares ${INKBENCH_ARGS:-}")
folders=
i=1
while [ "$i" -le "$shares" ]; do
    folders="$folders '$parts/$i-of-$shares'"
    i=$((i + 1))
done
# --kill-on-invalid-dep: a merge whose share failed goes away instead of waiting for ever.
merge=$(sbatch --parsable --job-name=inkbench-merge --dependency="afterok:$job" \
    --kill-on-invalid-dep=yes --output="$parts/merge.log" --open-mode=append \
    --wrap "exec '$program' merge $folders --out '$out'")
echo "shares: job $job; merge: job $merge; progress: $program run $file --status --out $out ${INKBENCH_ARGS:-}"
