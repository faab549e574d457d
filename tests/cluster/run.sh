#!/usr/bin/env bash
# Runs a small study under a Slurm of its own on the loopback address: four parts, one of them cancelled in the middle,
# taken up again and merged. The answer must have the bytes of the study in one piece.
#   bash tests/cluster/run.sh CAIRN
set -u
unset CDPATH
cairn=$(realpath "$1")
study=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../lessons/sandbox/cluster" && pwd)/study
words=(tradeoff --all --level 1 --quick --solvers 'si,jacobi')
for program in slurmctld slurmd sbatch munged; do
  PATH=$PATH:/usr/sbin
  if ! command -v $program >/dev/null; then printf 'skipped: %s is not installed (slurm-wlm, munge)\n' $program; exit 0; fi
done
if [[ $(id -u) != 0 ]]; then printf 'skipped: a Slurm on this machine alone has to be started by root\n'; exit 0; fi

scratch=$(mktemp -d)
export SLURM_CONF=$scratch/slurm.conf
passed=0 failed=0
check() {  # NAME CODE: notes whether a check held
  if [[ $2 == 0 ]]; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
  printf '%s: %s\n' "$1" "$([[ $2 == 0 ]] && printf ok || printf FAILED)"
}

stop() {
  local name pids=()
  scancel --user root 2>/dev/null
  for name in slurmd slurmctld munged; do
    if [[ -r $scratch/$name.pid ]]; then pids+=("$(<"$scratch/$name.pid")"); fi
  done
  kill "${pids[@]}" 2>/dev/null
  wait_for 10 no_process_is_left "${pids[@]}"  # they write their state as they end
  if [[ $failed == 0 ]]; then rm -rf "$scratch"; else printf 'what is left to look at: %s\n' "$scratch"; fi
}
trap stop EXIT

start() {
  mkdir -p "$scratch/state" "$scratch/spool"
  chmod 755 "$scratch"  # where munged looks for its socket, others must be able to come
  dd if=/dev/urandom of="$scratch/munge.key" bs=64 count=1 status=none && chmod 600 "$scratch/munge.key"
  munged --force --key-file="$scratch/munge.key" --socket="$scratch/munge.socket" --pid-file="$scratch/munged.pid" \
    --log-file="$scratch/munged.log" --seed-file="$scratch/munge.seed" || return
  cat >"$SLURM_CONF" <<END
ClusterName=cairn
SlurmctldHost=$(uname -n)(127.0.0.1)
SlurmctldPort=16817
SlurmdPort=16818
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$scratch/munge.socket
CryptoType=crypto/munge
StateSaveLocation=$scratch/state
SlurmdSpoolDir=$scratch/spool
SlurmctldPidFile=$scratch/slurmctld.pid
SlurmdPidFile=$scratch/slurmd.pid
SlurmctldLogFile=$scratch/slurmctld.log
SlurmdLogFile=$scratch/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
ReturnToService=2
KillWait=2
NodeName=$(uname -n) NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=main Nodes=$(uname -n) Default=YES MaxTime=INFINITE State=UP
END
  slurmctld -c && slurmd -c && wait_for 30 node_is_idle
}

# wait_for SECONDS COMMAND...: until the command holds; 1 if it never does.
wait_for() {
  local tries=$(($1 * 5))
  shift
  while ! "$@"; do
    tries=$((tries - 1))
    if [[ $tries -le 0 ]]; then return 1; fi
    sleep 0.2
  done
}
no_process_is_left() { ! kill -0 "$@" 2>/dev/null; }
node_is_idle() { [[ $(sinfo --noheader --format=%T 2>/dev/null) == idle ]]; }
in_the_middle() { [[ $(grep -c . "$parts/level1.4-of-4.journal" 2>/dev/null) -ge 6 ]]; }
no_job_is_left() { [[ -z $(squeue --noheader) ]]; }

start
code=$?
check 'a Slurm of one machine is idle' $code
if [[ $code != 0 ]]; then cat "$scratch"/*.log; printf '%s passed, %s failed\n' $passed $failed; exit 1; fi

# With what a shell, Slurm and the list behind --merge could take for something else than letters.
parts="$scratch/it's \"in\" \$(parts), 4 %a"
bash "$study" submit "$parts" 4 --cairn "$cairn" "${words[@]}"
check 'four parts and a merge are submitted' $?
wait_for 120 in_the_middle
check 'the last part is in the middle' $?
scancel "$(head -n 1 "$parts/jobs")_4"
wait_for 120 no_job_is_left
check 'no job is left, and none waits for ever' $?
[[ ! -e $parts/merged/level1.csv && ! -e $parts/done/4 ]]
check 'nothing is merged without the cancelled part' $?
said=$(bash "$study" status "$parts")
[[ $? == 1 && $said == *'3 of 4 parts are done; open: 4'*"again $(printf %q "$parts")"* ]]
check 'status names the part and says how to go on' $?
grep -q 'the same command goes on where it was' "$parts/log/part-4.txt"
check 'the cancelled part said that it goes on' $?
kept=$(wc -l <"$parts/level1.4-of-4.journal")
bash "$study" again "$parts"
wait_for 120 no_job_is_left
[[ $(bash "$study" status "$parts") == '4 of 4 parts are done; merged: '* ]]
check 'the part goes on, and all parts are merged' $?
"$cairn" "${words[@]}" --out "$scratch/whole" --progress never --quiet >/dev/null
cmp "$scratch/whole/level1.csv" "$parts/merged/level1.csv"
check "the bytes of the study in one piece ($((kept - 3)) rows of part 4 came from before)" $?
[[ $(wc -l <"$parts/merged/machines.csv") == 5 ]]
check 'the merge says which part ran where' $?

# A part for each line, what they print in the order of the lines; the second ends with 1, which is an answer.
printf 'list scenes\nrun stack --seconds 0.1 --sweeps 1\nlist solvers\n' >"$scratch/lines"
bash "$study" submit "$scratch/wishes" --lines "$scratch/lines" --cairn "$cairn"
wait_for 120 no_job_is_left
said=$("$cairn" list solvers --progress never)
[[ $(<"$scratch/wishes/merged/lines.txt") == '# cairn list scenes'*$'\n# cairn list solvers\n'"$said" ]]
check 'commands of their own, put together in their order' $?
bash "$study" submit "$scratch/wishes" 2 --cairn "$cairn" extremes 2>/dev/null
[[ $? == 2 ]]
check 'a folder that holds a study is refused' $?

# The same with Snakemake, where it is installed.
if command -v snakemake >/dev/null; then
  (cd "$scratch" && snakemake --quiet --snakefile "$(dirname "$study")/Snakefile" --cores 2 \
    --config parts=2 cairn="$cairn" out="$(basename "$parts") again" study="${words[*]}" >/dev/null 2>&1)
  cmp "$scratch/whole/level1.csv" "$parts again/merged/level1.csv"
  check 'the same bytes with Snakemake' $?
else
  printf 'skipped: Snakemake is not installed\n'
fi
printf '%s passed, %s failed\n' $passed $failed
[[ $failed == 0 ]]
