#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A world through examples/batch/with_slurm.sh on a Slurm of one node, which this starts and ends by itself: a job that
# fails leaves no table and the next run does what is missing; all is the same as in one run of the tool.
# Usage: slurm.sh TOOL FOREST      exit 77: not possible here
set -euo pipefail
tool=$(realpath "$1") forest=$(realpath "$2")
batch=$(dirname "$(realpath "${BASH_SOURCE[0]}")")/../../examples/batch
export PATH=$(dirname "$tool"):/usr/sbin:$PATH
for program in slurmctld slurmd sbatch munged; do
    command -v "$program" >/dev/null || { echo "skipped: no $program (script/bootstrap slurm)"; exit 77; }
done
[[ $EUID -eq 0 ]] || { echo "skipped: Slurm's daemons need root"; exit 77; }
work=$(mktemp -d /tmp/slurm.XXXXXX)
end() {
    kill "${daemons[@]}" 2>/dev/null || true
    wait 2>/dev/null || true
    rm -rf "$work"
}
daemons=()
trap end EXIT

mkdir -p "$work/state" "$work/spool"
chmod 755 "$work"
head -c 128 /dev/urandom >"$work/munge.key"
chmod 400 "$work/munge.key"
munged --foreground --force --num-threads=1 --key-file="$work/munge.key" --socket="$work/munge.socket" \
    --pid-file="$work/munge.pid" --log-file="$work/munge.log" --seed-file="$work/munge.seed" 2>/dev/null &
daemons+=($!)
ports=($(shuf -i 20000-29999 -n 2))
cat >"$work/slurm.conf" <<END
ClusterName=test
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=${ports[0]}
SlurmdPort=${ports[1]}
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
CredType=cred/munge
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=1,sched_interval=2
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
ReturnToService=2
MpiDefault=none
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$work/slurm.conf
for ((i = 0; i < 50; ++i)); do [[ -S $work/munge.socket ]] && break; sleep 0.1; done
slurmctld -D -i 2>/dev/null & daemons+=($!)
slurmd -D -N "$(hostname -s)" 2>/dev/null & daemons+=($!)
for ((i = 0; i < 150; ++i)); do [[ $(sinfo -h -o %t 2>/dev/null) == idle ]] && break; sleep 0.2; done
[[ $(sinfo -h -o %t) == idle ]] || { sinfo; tail -n 20 "$work"/*.log; echo "skipped: Slurm does not start here"; exit 77; }

world=$work/world/world.treewind
"$tool" tile "$forest" -o "$work/world" --size 50 >/dev/null
submitted() { # waits until its last job is gone
    local last
    last=$("$batch/with_slurm.sh" "$world" "$work/parts" "$work/slurm.csv" --speed 20)
    for ((i = 0; i < 600; ++i)); do [[ -n $(squeue -h -j "$last" 2>/dev/null) ]] || break; sleep 0.2; done
}
mv "$work/world/tiles/0_1.trees" "$work/aside"
submitted
[[ ! -f $work/slurm.csv ]] || { echo "failed: a table without row 1"; exit 1; }
grep -q "0_1.trees" "$work/parts/1.log" || { echo "failed: not said what is missing"; exit 1; }
mv "$work/aside" "$work/world/tiles/0_1.trees"
submitted
[[ -f $work/slurm.csv ]] || { tail -n 5 "$work"/parts/*.log "$work"/*.log; echo "failed: no table"; exit 1; }
"$tool" risk "$world" -o "$work/whole.csv" --speed 20 >/dev/null
cmp "$work/slurm.csv" "$work/whole.csv"
echo "passed: $(($(wc -l <"$work/slurm.csv") - 1)) trees"
