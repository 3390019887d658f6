#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hexapose authors
# SPDX-License-Identifier: MIT
# What a package has to be beyond installable: check.sh PACKAGE.deb. Lines on standard error, and status 1, where it is not.
set -euo pipefail

package=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
bad=0
complain() {
  echo "check: $1" >&2
  bad=1
}

LC_ALL=C.UTF-8 lintian --allow-root --fail-on error,warning "$package" || bad=1

root=$work/root
dpkg-deb -x "$package" "$root"
for file in "$root"/usr/share/applications/*.desktop; do
  desktop-file-validate "$file" || bad=1
  program=$(sed -nE 's/^Exec=([^ ]+).*/\1/p' "$file")
  [[ -x $root/usr/bin/$program ]] || complain "$(basename "$file") starts $program, which is not installed"
done
for file in "$root"/usr/share/metainfo/*.xml; do
  appstreamcli validate --no-net --pedantic "$file" >"$work/said" || { cat "$work/said" >&2 && bad=1; }
done
mkdir -p "$work/mime/packages"
cp "$root"/usr/share/mime/packages/*.xml "$work/mime/packages/"
XDG_DATA_HOME=$work update-mime-database "$work/mime" 2>"$work/said" && [[ ! -s $work/said ]] || { cat "$work/said" >&2 && bad=1; }

# Links of documents, headings apart, and what man pages name.
documents=0
while read -r file; do
  documents=$((documents + 1))
  while read -r target; do
    [[ -e $(dirname "$file")/$target ]] || complain "${file#"$root"}: dead link $target"
  done < <(grep -oE '\]\([^)#]+' "$file" | sed -E 's/^..//' | grep -vE '^[a-z]+://' || true)
done < <(find "$root/usr/share/doc" -name '*.md')
((documents > 5)) || complain "only $documents documents were found"
while read -r target; do
  [[ -e $root$target ]] || complain "a man page names $target, which is not installed"
done < <(zcat "$root"/usr/share/man/man1/*.gz | grep -oE '/usr/share/(doc/)?hexapose[^ ,;]*' || true)

# Every program has its page and its completions, which its shell can read.
for program in "$root"/usr/bin/*; do
  name=$(basename "$program")
  for file in "man/man1/$name.1.gz" "bash-completion/completions/$name" "zsh/vendor-completions/_$name" \
    "fish/vendor_completions.d/$name.fish"; do
    [[ -s $root/usr/share/$file ]] || complain "$name has no $file"
  done
  bash -n "$root/usr/share/bash-completion/completions/$name" || bad=1
done
exit $bad
