#!/usr/bin/env bash
# The README of this example: README.in.md with the difference of the programs in it.
cd "$(dirname "$0")" || exit 1
while IFS= read -r line; do
  if [ "$line" = "@DIFFERENCE@" ]; then
    echo '```diff'
    diff -U2 --label plain.cc --label with_contact.cc plain.cc with_contact.cc
    echo '```'
  else
    printf '%s\n' "$line"
  fi
done < README.in.md
