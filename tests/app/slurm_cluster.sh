#!/bin/bash
# `batch --slurm` on a real Slurm: a controller and two nodes on this machine, on loopback, in a temporary folder. A
# job hangs until Slurm's time limit, one is killed, a node is drained and resumed, a job is started again: every
# case is done exactly once. Takes two minutes, most of it the shortest time limit that Slurm has.
#   slurm_cluster.sh HANDLEBODY_CLI          exit code 77: skipped, there is no Slurm (Debian: slurmctld slurmd)
# Slurm that is not installed but unpacked somewhere: its folders in PATH and LD_LIBRARY_PATH, HANDLEBODY_SLURM_PLUGINS.
set -u
cli=$1
export PATH=$PATH:/usr/sbin
find_program() { command -v "$1" || command -v "$1-wlm"; }
plugins=${HANDLEBODY_SLURM_PLUGINS:-$(ls -d /usr/lib/*/slurm-wlm /usr/lib/*/slurm 2>/dev/null | head -1)}
skip() { echo "skipped: $1"; exit 77; }
controller=$(find_program slurmctld) && node=$(find_program slurmd) && step=$(find_program slurmstepd) &&
  command -v sbatch > /dev/null || skip "there is no Slurm"
[ -e "$plugins/auth_none.so" ] && [ -e "$plugins/cred_none.so" ] || skip "this Slurm has no auth/none"
[ "$(id -u)" = 0 ] || skip "slurmd needs root"

dir=$(mktemp -d /tmp/handlebody-slurm-XXXXXX)
daemons=()
stop() {
  for process in "${daemons[@]}"; do kill "$process" 2> /dev/null; done
  for process in "${daemons[@]}"; do wait "$process" 2> /dev/null; done
  rm -rf "$dir"
}
trap stop EXIT
fail() {
  echo "FAILED: $1"
  squeue 2>&1
  cat "$dir"/out/summary.csv "$dir"/out/slurm/*/*.txt 2> /dev/null
  tail -n 5 "$dir"/log-* 2> /dev/null
  exit 1
}
# Until `$2…` succeeds, for $1 seconds.
wait_until() {
  local end=$((SECONDS + $1)); shift
  until "$@"; do [ $SECONDS -lt $end ] || return 1; sleep 0.02; done
}

port=$((20000 + $$ % 20000))
export SLURM_CONF=$dir/slurm.conf
cat > "$SLURM_CONF" << END
ClusterName=test
SlurmctldHost=localhost
SlurmctldPort=$port
AuthType=auth/none
CredType=cred/none
SlurmUser=root
PluginDir=$plugins
StateSaveLocation=$dir/state
SlurmctldPidFile=$dir/slurmctld.pid
SlurmdPidFile=$dir/slurmd-%n.pid
SlurmdSpoolDir=$dir/spool-%n
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
KillWait=2
MpiDefault=none
NodeName=n1 NodeHostname=localhost NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=1
NodeName=n2 NodeHostname=localhost NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=1
PartitionName=main Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
END
mkdir "$dir/state" "$dir/spool-n1" "$dir/spool-n2"
"$controller" -D -i > "$dir/log-controller" 2>&1 & daemons+=($!)
for n in n1 n2; do "$node" -D -N $n -d "$step" > "$dir/log-$n" 2>&1 & daemons+=($!); done
two_idle() { [ "$(sinfo -h -N -t idle -o %N 2> /dev/null | wc -l)" = 2 ]; }
wait_until 30 two_idle || fail "the cluster does not start"

"$cli" phantom sphere -o "$dir/s.mha" --size 48,48,48 --spacing 2,2,2 > "$dir/phantom" || fail "no phantom"
{
  echo case,volume,seed,balloon
  for i in $(seq 1 14); do
    balloon=1.$((i % 3)); [ $i = 7 ] && balloon=heavy
    echo "c$i,s.mha,\"48,48,48,8\",$balloon"
  done
} > "$dir/study.csv"
cd "$dir" || exit 1

# Of the process that does the work of a case, by what it writes.
worker() { pgrep -f -- "--report=$dir/out/cases/.tmp-$1/"; }
row_is() { grep -q "^$1,[0-9]*,s.mha,$2," out/summary.csv; }
queue_is_empty() { [ -z "$(squeue -h)" ]; }
made() { ls -d out/cases/c* 2> /dev/null | wc -l; }
at_least() { [ "$(made)" -ge "$1" ]; }

"$cli" batch study.csv -o out --slurm --time=1 || fail "not submitted"
first=$(grep -o '^[0-9]*' out/slurm/1/sbatch.out)  # the summary's; the array's is the one before
wait_until 30 worker c1 > /dev/null || fail "c1 does not begin"
kill -STOP "$(worker c1)"
wait_until 30 worker c2 > /dev/null || fail "c2 does not begin"
kill -KILL "$(ps -o ppid= -p "$(worker c2)")"
wait_until 60 at_least 3 || fail "the others do not go on"
busy=$(squeue -h -t R -o '%i %N' | sed -n "s/^$((first - 1))_1 //p")
other=$([ "$busy" = n1 ] && echo n2 || echo n1)
scontrol update NodeName=$other State=DRAIN Reason=test
drained() { [ "$(squeue -h -t R | wc -l)" = 1 ]; }
wait_until 30 drained || fail "the node is not drained"
before=$(made); sleep 2
[ "$(made)" = "$before" ] || fail "a case was done while one node was busy and the other drained"
scontrol update NodeName=$other State=RESUME
wait_until 180 queue_is_empty || fail "the queue does not empty"
row_is c7 refused || fail "c7 is a bad row"
for c in c1 c2; do row_is $c failed || fail "$c was ended"; done
for i in 3 4 5 6 8 9 10 11 12 13 14; do row_is c$i done || fail "c$i is not done"; done
ls -di out/cases/c* > identities

"$cli" batch study.csv -o out --slurm || fail "not submitted again"
wait_until 60 queue_is_empty || fail "the queue does not empty"
[ "$(cat out/slurm/*/case-*.txt | grep -c ': done$')" = 13 ] || fail "not every case was done once"
[ "$(ls out/slurm/2/case-*.txt | wc -l)" = 2 ] || fail "more than two cases were submitted again"
again=$((first - 1))_3
scontrol requeue $again && scontrol update JobId=$again StartTime=now && wait_until 60 queue_is_empty ||
  fail "a job is not started again"
"$cli" batch study.csv -o out --only-summary --quiet
[ $? = 7 ] || fail "a bad row is left"
[ "$(grep -c ',done,' out/summary.csv)" = 13 ] || fail "13 are to be done"
[ "$(ls -di out/cases/c* | grep -cxF -f identities)" = 11 ] || fail "a case was done twice"
[ -z "$(ls -A out/cases | grep '^\.tmp')" ] || fail "something half-done lies about"
# The same bits as without a cluster.
"$cli" batch study.csv -o alone --jobs 2 --quiet > /dev/null 2>&1
for i in 1 2 3 4 5 6 8 9 10 11 12 13 14; do cmp out/cases/c$i/mesh.stl alone/cases/c$i/mesh.stl || fail "c$i differs"; done
echo "13 cases done once, on $(sinfo -h -N -o %N | wc -l) nodes, by $(sinfo --version)"
