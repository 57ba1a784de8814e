#!/usr/bin/env bash
# A campaign through a real Slurm: starts munge, slurmctld and slurmd of its own in a scratch folder (loopback only, own
# ports and sockets, so that a Slurm of the machine is not touched), submits a tiny study, waits for the collect job, and
# compares features.csv with that of a local run. Only core_s, the time a cut took, may differ.
#   submit.sh BITROCK_PROGRAM SOURCE_FOLDER
# Exit status 77: skipped (not root, or no Slurm here).
set -euo pipefail
bitrock=$1
source=$2

[ "$(id -u)" -eq 0 ] || { echo "skipped: the daemons need root"; exit 77; }
PATH=$PATH:/usr/sbin
for tool in munged slurmctld slurmd sbatch squeue scontrol; do
  command -v $tool >/dev/null || { echo "skipped: no $tool (Debian: slurmctld slurmd slurm-client munge)"; exit 77; }
done

dir=$(mktemp -d /var/tmp/bitrock_slurm.XXXXXX)
chmod 755 "$dir"
mkdir "$dir"/{munge,state,spool,log}
port=$((20000 + $$ % 20000))
host=$(hostname -s)

# Their process numbers, those that still run.
daemons() {
  local name
  for name in slurmd slurmctld munged; do cat "$dir/$name.pid" 2>/dev/null; done | while read -r pid; do
    if kill -0 "$pid" 2>/dev/null; then echo "$pid"; fi
  done
}

stop_daemons() {
  local status=$?
  set +e
  # shellcheck disable=SC2046
  [ -z "$(daemons)" ] || kill $(daemons)
  for ((i = 0; i < 50; ++i)); do
    [ -z "$(daemons)" ] && break
    sleep 0.1
  done
  if [ $status -ne 0 ]; then
    tail -n 20 "$dir"/log/*.log "$dir"/*.log "$dir"/camp*/slurm/*.log 2>/dev/null
    echo "the scratch folder is kept: $dir"
  else
    rm -rf "$dir"
  fi
  exit $status
}
trap stop_daemons EXIT

dd if=/dev/urandom of="$dir/munge/key" bs=128 count=1 2>/dev/null
chmod 400 "$dir/munge/key"
munged --force --key-file="$dir/munge/key" --socket="$dir/munge/socket" --pid-file="$dir/munged.pid" \
  --log-file="$dir/log/munged.log" --seed-file="$dir/munge/seed" 2>"$dir/log/munged_start.log"

cat >"$dir/slurm.conf" <<END
ClusterName=bitrock
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$dir/munge/socket
CredType=cred/munge
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
StateSaveLocation=$dir/state
SlurmdSpoolDir=$dir/spool
SlurmctldPidFile=$dir/slurmctld.pid
SlurmdPidFile=$dir/slurmd.pid
SlurmctldLogFile=$dir/log/slurmctld.log
SlurmdLogFile=$dir/log/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0,sched_interval=1
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MinJobAge=3600
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=4000 State=UNKNOWN
PartitionName=work Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$dir/slurm.conf
slurmctld
slurmd

# Waits until a command says yes, at most so many seconds.
wait_until() {
  local seconds=$1 what=$2
  shift 2
  for ((i = 0; i < 5 * seconds; ++i)); do
    if "$@"; then return; fi
    sleep 0.2
  done
  echo "gave up after $seconds s: $what"
  exit 1
}
node_is_idle() { [ "$(sinfo -h -o %t 2>/dev/null)" = idle ]; }
wait_until 60 "the node becomes idle" node_is_idle

cat >"$dir/study.toml" <<END
rock = "$source/campaigns/rocks/article.toml"
seeds = [3, 4]
[grid]
cutter_speeds_m_per_s = [0.1, 2]
depths_of_cut_mm = [2]
back_rakes_deg = [15]
[cut]
cut_length_mm = 4
[bed]
length_mm = 20
height_mm = 12
END
"$bitrock" campaign run "$dir/study.toml" --dir "$dir/local" --jobs 2 >"$dir/local.log"
"$bitrock" campaign collect "$dir/study.toml" --dir "$dir/local" >>"$dir/local.log"

# 4 cuts in 3 tasks: one task runs a block of two. A name with a space shows that paths are quoted.
"$bitrock" campaign submit "$dir/study.toml" --dir "$dir/camp one" --engine slurm --tasks 3 --time 00:10:00 --mem 500 \
  --json "$dir/submit.json"
array=$(sed -n 's/.*"array_job": "\([0-9]*\)".*/\1/p' "$dir/submit.json")
collect=$(sed -n 's/.*"collect_job": "\([0-9]*\)".*/\1/p' "$dir/submit.json")

# A task that is requeued while it works is told to end (SIGTERM), and later begins its cut again.
task() { scontrol show job "${array}_1" 2>/dev/null; }
has_started() { task | grep -q 'JobState=\(RUNNING\|COMPLET\)'; }
waits_for_its_time() { task | grep -q Reason=BeginTime; }
wait_until 60 "the first task starts" has_started
if scontrol requeue "${array}_1"; then
  wait_until 60 "the requeued task has ended its first life" waits_for_its_time
  # slurmd refuses a job whose new credential was made in the very second in which the old one was revoked.
  sleep 2
  scontrol update "JobId=${array}_1" StartTime=now  # Slurm would let it wait two minutes
fi

ended() { scontrol show job "$1" 2>/dev/null | grep -q 'JobState=\(COMPLETED\|FAILED\|CANCELLED\|TIMEOUT\|NODE_FAIL\)'; }
wait_until 240 "the collect job ends" ended "$collect"
scontrol show job "$collect" | grep -q JobState=COMPLETED || { echo "the collect job failed"; exit 1; }

# All columns but the time a cut took, found by its name.
without_core_time() {
  awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "core_s") skip = i }
           { line = ""; for (i = 1; i <= NF; ++i) if (i != skip) line = line "," $i; print line }' "$1"
}
without_core_time "$dir/local/features.csv" >"$dir/local.csv"
without_core_time "$dir/camp one/features.csv" >"$dir/slurm.csv"
[ "$(wc -l <"$dir/local.csv")" -eq 5 ] || { echo "the local run has not made its 4 rows"; exit 1; }
cmp "$dir/local.csv" "$dir/slurm.csv"
grep -q "stopped by the user" "$dir/camp one/slurm/task_1.log" || echo "(the task was too fast to be requeued at work)"
echo "4 cuts through Slurm (array job $array, collect job $collect) equal the local run, byte for byte but for core_s"
