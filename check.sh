#!/bin/bash
cd /tmp/hist; export CARGO_TARGET_DIR=/tmp/target-hist
for c in $(git log --reverse --format=%h 5954a9d..rebuilt); do git checkout -q $c; nice -n 5 cargo test --locked -q > /tmp/hist-$c.log 2>&1; echo "$c $? $(grep -h -E 'FAILED|^error' /tmp/hist-$c.log | head -4 | tr '\n' ';') $(git log -1 --format=%s | cut -c1-60)"; done > /tmp/hist-result.txt 2>&1
