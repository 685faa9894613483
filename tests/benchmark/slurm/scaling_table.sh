#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The Markdown table of a scaling study, from what its jobs have left. Usage: scaling_table.sh DIR
set -euo pipefail
[[ $# -eq 1 && -d $1 ]] || { echo "usage: scaling_table.sh DIR" >&2; exit 2; }

stage() { sed -n "s/^time .*  $1 \([0-9.]*\) s.*/\1/p" "$2"; }

echo "| nodes | ranks | threads | elements | time (s) | Newton | linear | tangent (s) | set-up (s) | linear solve (s) | ms an iteration | kB sent an iteration | messages |"
echo "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"
for job in $(find "$1" -mindepth 2 -maxdepth 2 -name job | sort -V); do
  folder=$(dirname "$job")
  read -r nodes ranks threads elements <"$job"
  log=$folder/output
  seconds=$(sed -n 's/^\([0-9.]*\) s on .*/\1/p' "$log" 2>/dev/null || true)
  if [[ -z $seconds ]]; then
    echo "| $nodes | $ranks | $threads | $elements | not finished | | | | | | | | |"
    continue
  fi
  IFS=, read -r _ _ newton linear _ < <(tail -n 1 "$folder/history.csv")
  solve=$(stage 'linear solve' "$log")
  sent=$(sed -n 's/^exchange .*busiest rank \([0-9.]*\) kB.*/\1/p' "$log")
  messages=$(sed -n 's/^exchange .* in \([0-9]*\) messages.*/\1/p' "$log")
  each=$(awk -v s="$solve" -v n="$linear" 'BEGIN { printf "%.2f", (n > 0 ? 1e3 * s / n : 0) }')
  echo "| $nodes | $ranks | $threads | $elements | $seconds | $newton | $linear | $(stage tangent "$log") |" \
    "$(stage preconditioner "$log") | $solve | $each | ${sent:-0} | ${messages:-0} |"
done
