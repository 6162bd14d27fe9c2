# SPDX-License-Identifier: BSD-3-Clause
"""What the host is asked to do while the probe answers; each scene gives the lines of its part of the log."""

from actionlib_msgs.msg import GoalStatus

from probe_log import collapse, without_repeats
from probe_world import BLOCKED, make_pose, status_name

A, B = (1.0, -1.0), (-1.0, 1.0)
COMPUTE = "computeVelocityCommands"
TERMINAL = (GoalStatus.PREEMPTED, GoalStatus.SUCCEEDED, GoalStatus.ABORTED, GoalStatus.REJECTED)


class Failed(Exception):
    """Something the scene waits for did not come."""


class Scene:
    """One scene: does things, waits for what follows, writes it down."""

    def __init__(self, world, title):
        self.world, self.lines = world, ["", "== " + title]

    def expect(self, what, condition):
        if not self.world.wait(condition):
            raise Failed("%s: waited in vain for %s" % (self.lines[1], what))

    def answer(self, how):
        if not self.world.answer(how):
            raise Failed("%s: the probe did not hear its answer" % self.lines[1])

    def cycles(self, number=8):
        """Waits for so many more calls of computeVelocityCommands."""
        target = self.world.count(COMPUTE) + number
        self.expect("%d control cycles" % number, lambda: self.world.count(COMPUTE) >= target)

    def ended(self, handle):
        self.expect("the goal's end", lambda: handle.get_goal_status() in TERMINAL)

    def note(self, text=None, until=None, **handles):
        """Writes down what was gathered since the last note; `until`: only calls before the last such one."""
        events, commands, goals, feedback = self.world.take()
        calls = [event for event in events if not event.startswith("callback")]
        if until:
            calls = calls[:max(i for i, call in enumerate(calls) if call.startswith(until))]
        self.lines += ["-- " + text] if text else []
        self.lines += ["call: " + line for line in collapse(calls)] or ["call: none"]
        self.lines.append("cmd_vel: " + (", ".join(without_repeats(commands)) or "none"))
        self.lines += ["current_goal: " + goal for goal in goals]
        self.lines.append("feedback: " + ("yes" if feedback else "no"))
        self.lines += ["goal %s: %s" % (name, status_name(handle)) for name, handle in handles.items()]

    def finish(self, **handles):
        """Waits until all is quiet, then writes down the rest."""
        for handle in handles.values():
            self.ended(handle)
        self.world.wait_calm()
        self.note(**handles)
        return self.lines


def start_up(world):
    scene = Scene(world, "the host starts")
    scene.expect("initialize", lambda: world.count("initialize") == 1)
    scene.answer("drive")
    events = world.take()[0]
    return scene.lines + ["call: " + event for event in events]


def drive_and_arrive(world):
    scene = Scene(world, "true with a velocity, then the goal is reached")
    scene.answer("drive")
    goal = world.send(*A)
    scene.cycles()
    scene.answer("reached")
    return scene.finish(A=goal)


def reached_at_once(world):
    scene = Scene(world, "the goal is reached from the start")
    scene.answer("reached")
    return scene.finish(A=world.send(*A))


def hold(world):
    scene = Scene(world, "true with zero for longer than controller_patience, then cancel")
    scene.answer("hold")
    goal = world.send(*A)
    scene.cycles(40)  # 2 s at 20 Hz, the patience is 1 s
    scene.note("held", A=goal)
    goal.cancel()
    scene.ended(goal)
    world.wait_calm()
    _, commands, _, _ = world.take()
    return scene.lines + ["cmd_vel: " + ", ".join(without_repeats(commands)), "goal A: " + status_name(goal)]


def cancel_while_moving(world):
    scene = Scene(world, "cancel while moving")
    scene.answer("drive")
    goal = world.send(*A)
    scene.cycles()
    goal.cancel()
    return scene.finish(A=goal)


def fail_once(world):
    scene = Scene(world, "false once")
    scene.answer("fail_once")
    goal = world.send(*A)
    scene.cycles()
    scene.answer("reached")
    return scene.finish(A=goal)


def fail_while_moving(world):
    scene = Scene(world, "false once while moving")
    scene.answer("drive")
    goal = world.send(*A)
    scene.cycles()
    scene.answer("fail_once")
    scene.cycles()
    scene.answer("reached")
    return scene.finish(A=goal)


def fail_for_ever(world):
    scene = Scene(world, "false until controller_patience has passed")
    scene.answer("fail")
    return scene.finish(A=world.send(*A))


def refuse_plan(world):
    scene = Scene(world, "setPlan returns false")
    scene.answer("refuse_plan")
    return scene.finish(A=world.send(*A))


def replace_goal(world):
    scene = Scene(world, "a new goal while moving")
    scene.answer("drive")
    first = world.send(*A)
    scene.cycles()
    second = world.send(*B)
    plans = world.count("setPlan")
    scene.expect("the plan to B", lambda: world.count("setPlan") > plans)
    scene.cycles()
    scene.answer("reached")
    return scene.finish(A=first, B=second)


def not_current(world):
    scene = Scene(world, "no scan for longer than expected_update_rate, then scans again")
    scene.answer("drive")
    goal = world.send(*A)
    scene.expect("a command", lambda: "moving" in world.commands)
    scene.cycles()
    world.scanning = False
    scene.expect("zero velocity", lambda: world.commands[-1:] == ["zero"])
    scene.note("the scans have stopped")
    scene.expect("more zeros", lambda: len(world.commands) > 10)
    scene.note("while they are missing", A=goal)
    scene.expect("one more zero", lambda: world.commands)
    world.scanning = True
    scene.cycles()
    scene.answer("reached")
    return scene.finish(A=goal)


def blocked_goal(world):
    scene = Scene(world, "a goal inside an obstacle, until planner_patience has passed")
    scene.answer("drive")
    return scene.finish(blocked=world.send(*BLOCKED))


def cancel_while_planning(world):
    scene = Scene(world, "cancel while no plan can be found")
    scene.answer("drive")
    goal = world.send(*BLOCKED)
    scene.expect("the goal to be taken in hand", lambda: world.goals and world.commands)
    goal.cancel()
    return scene.finish(blocked=goal)


def replace_by_blocked_goal(world):
    scene = Scene(world, "a new goal inside an obstacle while moving")
    scene.answer("drive")
    first = world.send(*A)
    scene.cycles()
    return scene.finish(A=first, blocked=world.send(*BLOCKED))


def bad_quaternion(world):
    scene = Scene(world, "a goal whose quaternion has no length")
    scene.answer("drive")
    return scene.finish(A=world.send(*A, w=0.0))


def simple_goal(world):
    scene = Scene(world, "a goal through move_base_simple/goal")
    scene.answer("drive")
    world.simple_goal_publisher.publish(make_pose(*B))
    scene.cycles()
    scene.answer("reached")
    return scene.finish()


def replanning(world):
    scene = Scene(world, "planner_frequency above zero: plans are replaced while moving")
    scene.answer("drive")
    goal = world.send(*A)
    scene.expect("six plans", lambda: world.count("setPlan") >= 6)
    scene.note(until="setPlan", A=goal)
    scene.answer("reached")
    scene.ended(goal)
    world.wait_calm()
    world.take()
    return scene.lines + ["goal A: " + status_name(goal)]


def oscillation(world):
    scene = Scene(world, "true with zero for longer than oscillation_timeout")
    scene.answer("hold")
    return scene.finish(A=world.send(*A))


def start_up_with_recoveries(world):
    scene = Scene(world, "the host starts, with two recovery behaviours")
    scene.expect("both recoveries", lambda: world.count("initialize") == 3)
    scene.answer("drive")
    return scene.lines + ["call: " + event for event in world.take()[0]]


def recover_and_drive(world):
    scene = Scene(world, "false until controller_patience has passed; a recovery helps")
    scene.answer("fail")
    goal = world.send(*A)
    scene.expect("the first recovery", lambda: world.count("runBehavior") >= 1)
    scene.answer("drive")
    scene.cycles()
    scene.answer("fail")  # what helped counts no more: the first one again
    scene.expect("the first recovery again", lambda: world.count("runBehavior") >= 2)
    scene.answer("reached")
    return scene.finish(A=goal)


# Parameters of a host, and what is asked of it.
RECOVERIES = {"recovery_behavior_enabled": True,
              "recovery_behaviors": [{"name": name, "type": "hidwa_probe_planner/ProbeRecovery"}
                                     for name in ("first", "second")]}
OSCILLATION = {"planner_frequency": 0.0, "oscillation_timeout": 1.0, "shutdown_costmaps": False}
RUNS = [
    ("planner_frequency 0", {"planner_frequency": 0.0, "oscillation_timeout": 0.0},
     [start_up, drive_and_arrive, reached_at_once, hold, cancel_while_moving, fail_once, fail_while_moving,
      fail_for_ever, refuse_plan, replace_goal, not_current, blocked_goal, cancel_while_planning,
      replace_by_blocked_goal, bad_quaternion, simple_goal]),
    ("planner_frequency 2", {"planner_frequency": 2.0, "oscillation_timeout": 0.0}, [start_up, replanning]),
    ("shutdown_costmaps", {"planner_frequency": 0.0, "oscillation_timeout": 0.0, "shutdown_costmaps": True},
     [start_up, drive_and_arrive, drive_and_arrive]),
    ("oscillation_timeout 1", OSCILLATION, [start_up, oscillation]),
    ("two recovery behaviours", dict(RECOVERIES, planner_frequency=0.0, oscillation_timeout=0.0),
     [start_up_with_recoveries, blocked_goal, fail_for_ever, recover_and_drive]),
    ("two recovery behaviours, oscillation_timeout 1", dict(RECOVERIES, **OSCILLATION),
     [start_up_with_recoveries, oscillation]),
]
