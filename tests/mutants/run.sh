#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hexapose authors
# SPDX-License-Identifier: MIT
# What the tests notice: each mutant of tests/mutants/*.txt is one small fault put into one source, and some test has to
# fail of it. `./dev mutants` builds the tests and calls this. The sources are only read: a mutated copy is compiled
# alone and linked in front of the libraries of the build, so that the linker takes it in place of the original.
#
#   run.sh programs LISTS...               the test programs that the lists name; fails where one does not fit the sources
#   run.sh run BUILD LISTS... [-- PATTERN] every mutant whose file or reason matches; 1 where too many survive
set -euo pipefail

self=$(readlink -f "${BASH_SOURCE[0]}")
root=$(dirname "$(dirname "$(dirname "$self")")")
needed=95 # per cent killed

fail() {
  echo "mutants: $1" >&2
  exit 2
}

# read_list FILE: every mutant of a list as the function `mutant` with $file, $tests, $why, $old and $new set.
# A mutant is a paragraph:
#   file core/record/csv_reader.cpp
#   test record_test --gtest_filter=Csv.*     the program, and the tests that should notice first
#   why  what goes wrong
#   - the exact text that is taken out, which stands in the file once; more such lines make one text of several lines
#   + what is put in its place, line by line; no such line: nothing
read_list() {
  local list=$1 line number=0 start=0
  file='' tests='' why='' old='' new=''
  while IFS= read -r line || [[ -n $line ]]; do
    number=$((number + 1))
    [[ -n $file$tests$why$old$new ]] || start=$number
    case $line in
      '#'*) ;;
      'file '*) file=${line#file } ;;
      'test '*) tests=${line#test } ;;
      'why '*) why=${line#why } ;;
      '- '*) old+=${old:+$'\n'}${line#- } ;;
      '+ '*) new+=${new:+$'\n'}${line#+ } ;;
      '') [[ -z $file$tests$why$old$new ]] || finish "${list#"$root"/}:$start" ;;
      *) fail "${list#"$root"/}:$number: not a line of a mutant: $line" ;;
    esac
  done <"$list"
  [[ -z $file$tests$why$old$new ]] || finish "${list#"$root"/}:$start"
}

finish() { # finish PLACE
  [[ -n $file && -n $tests && -n $why && -n $old ]] || fail "$1: a mutant needs file, test, why and the old text"
  mutant "$1"
  file='' tests='' why='' old='' new=''
}

# ---------------------------------------------------------------- one mutant

compile_command() { # compile_command SOURCE: the one that compiles it
  grep -F -m1 -- " -c $root/$1" "$build/mutants.commands" || return 1
}

link_command() { # link_command PROGRAM
  grep -F -m1 -- " -o tests/$1 " "$build/mutants.commands" || return 1
}

# try FOLDER: the mutant that lies there (place, file, tests, old, new) is built and run; its verdict goes to FOLDER/verdict.
try() {
  local folder=$1 file tests program compile link object text rest
  file=$(<"$folder/file") tests=$(<"$folder/tests")
  program=${tests%% *}
  mkdir -p "$folder/$(dirname "$file")" "$folder/tmp"
  text=$(cat "$root/$file" && echo .) && text=${text%.}
  rest=${text#*"$(<"$folder/old")"}
  printf '%s' "${text%"$(<"$folder/old")$rest"}$(<"$folder/new")$rest" >"$folder/$file"

  object=$folder/mutant.o
  compile=$(compile_command "$file")
  compile="${compile%% -MD *} -o $object -c $folder/$file" # without the list of headers that ninja wants
  link=$(link_command "$program")
  link=${link/ -o tests\/$program / $object -o $folder\/$program }
  cd "$build"
  if ! bash -c "$compile" >"$folder/compile.log" 2>&1 || ! bash -c "$link" >>"$folder/compile.log" 2>&1; then
    echo "unbuilt" >"$folder/verdict"
    return 0
  fi
  export TMPDIR=$folder/tmp QT_QPA_PLATFORM=offscreen
  # shellcheck disable=SC2086 # the tests are several words
  if notices "$folder" ${tests#"$program"} || { [[ $tests != "$program" ]] && notices "$folder"; }; then
    echo "killed" >"$folder/verdict"
  else
    echo "survived" >"$folder/verdict"
  fi
  rm -rf "$folder/tmp" "$folder/$program" "$object"
}

# notices FOLDER [FILTER]: a test fails, crashes or comes to no end.
notices() {
  local folder=$1
  { # the shell's own word of a crash is not of interest
    ! timeout -k 5 "$(<"$folder/patience")" "$folder/$program" --gtest_fail_fast --gtest_brief=1 "${@:2}" \
      >"$folder/test.log" 2>&1 </dev/null
  } 2>/dev/null
}

# ---------------------------------------------------------------- all of them

programs() {
  local list faults=0 found=
  mutant() {
    found+=${tests%% *}$'\n'
    fits "$1" || faults=$((faults + 1))
  }
  for list in "$@"; do read_list "$list"; done
  ((faults == 0)) || fail "$faults mutants do not fit the sources, above"
  sort -u <<<"${found%$'\n'}"
}

# fits PLACE: the old text stands in the file once.
fits() {
  local text rest
  text=$(cat "$root/$file" 2>/dev/null) || true
  rest=${text#*"$old"}
  if [[ -z $text ]]; then
    echo "$1: no such file: $file" >&2
  elif [[ $file != *.cpp ]]; then
    echo "$1: only a .cpp can be compiled alone: $file" >&2
  elif [[ $rest == "$text" ]]; then
    echo "$1: the old text is not in $file: $old" >&2
  elif [[ $rest == *"$old"* ]]; then
    echo "$1: the old text stands in $file more than once: $old" >&2
  else
    return 0
  fi
  return 1
}

run() {
  build=$1
  shift
  local lists=() pattern= list faults=0 count=0 scratch program started ended
  while (($#)) && [[ $1 != -- ]]; do lists+=("$1") && shift; done
  (($# < 2)) || pattern=$2
  wanted=$(programs "${lists[@]}")
  mapfile -t wanted <<<"$wanted"
  (cd "$build" && ninja -t commands "${wanted[@]/#/tests/}") >"$build/mutants.commands"

  # Tests that fail by themselves prove nothing; and how long they take, times ten, is the patience with a mutant.
  declare -A patience
  for program in "${wanted[@]}"; do
    started=$SECONDS
    QT_QPA_PLATFORM=offscreen "$build/tests/$program" --gtest_brief=1 >"$build/mutants.log" 2>&1 </dev/null || {
      cat "$build/mutants.log" >&2
      fail "$program fails without any mutant"
    }
    ended=$SECONDS
    patience[$program]=$((60 + 10 * (ended - started)))
  done

  scratch=$build/mutants
  rm -rf "$scratch"
  mutant() {
    local place=$1 folder
    [[ "$file $why" == *$pattern* ]] || return 0
    count=$((count + 1))
    folder=$scratch/$(printf %03d "$count")
    mkdir -p "$folder"
    if ! compile_command "$file" >/dev/null; then
      echo "$place: $file is no source of ${tests%% *}" >&2
    elif ! link_command "${tests%% *}" >/dev/null; then
      echo "$place: no test program ${tests%% *}" >&2
    else
      printf '%s' "$place" >"$folder/place" && printf '%s' "$file" >"$folder/file"
      printf '%s' "$tests" >"$folder/tests" && printf '%s' "$why" >"$folder/why"
      printf '%s' "$old" >"$folder/old" && printf '%s' "$new" >"$folder/new"
      printf '%s' "${patience[${tests%% *}]}" >"$folder/patience"
      return 0
    fi
    faults=$((faults + 1))
  }
  for list in "${lists[@]}"; do read_list "$list"; done
  ((faults == 0)) || fail "$faults mutants do not fit the sources, above"
  ((count > 0)) || fail "no mutant matches '$pattern'"

  printf '%s\n' "$scratch"/* | xargs -P "$(nproc)" -n 1 "$self" try "$build"
  summary "$scratch"
}

summary() {
  local folder verdict killed=0 survived=0 unbuilt=0 all
  for folder in "$1"/*; do
    verdict=$(<"$folder/verdict")
    case $verdict in
      killed) killed=$((killed + 1)) ;;
      survived) survived=$((survived + 1)) ;;
      *) unbuilt=$((unbuilt + 1)) && tail -n 5 "$folder/compile.log" >&2 ;;
    esac
    printf '%-8s %s: %s\n' "$verdict" "$(<"$folder/place")" "$(<"$folder/why")"
  done
  all=$((killed + survived + unbuilt))
  echo "$all mutants: $killed killed, $survived survived, $unbuilt do not build; $((100 * killed / all)) % killed, $needed % needed"
  ((unbuilt == 0 && 100 * killed >= needed * all))
}

case ${1:-} in
  programs) programs "${@:2}" ;;
  run) run "${@:2}" ;;
  try) # a part of run, once for each mutant
    build=$2
    try "$3"
    ;;
  *) fail "usage: run.sh programs LISTS... | run.sh run BUILD LISTS... [-- PATTERN]" ;;
esac
