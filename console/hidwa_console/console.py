# SPDX-License-Identifier: BSD-3-Clause
"""The console: joins desk, scene, goals, tuning, recorder and camera, in the server's one thread."""
import concurrent.futures
import time

import rospy
from actionlib_msgs.msg import GoalID, GoalStatusArray
from move_base_msgs.msg import MoveBaseActionGoal, MoveBaseActionResult

from hidwa_tools.pose_goal import goal_message

from . import foxglove, server
from .camera import Camera
from .desk import Desk
from .goals import Goals
from .outputs import Outlet
from .robot import planners
from .scene import Scene
from .wire import yaw_of

TICK = 0.05           # [s]
SLOW_TICK = 1.0       # [s]
DEFAULT_TIMEOUT = 0.5  # [s], the planner's own default


class Console:
    """`loop`: Tornado's. `parts`: names, robot, tuning, device and recorder (see robot, tuning, outputs, recorder); settings:
    desk.Settings; `study`: a study.Session or None."""

    def __init__(self, loop, access, secure, settings, parts, options, regions=(), study=None):
        self.loop, self.access, self.secure = loop, access, secure
        self.names, self.robot, self.tuning, self.device, self.recorder = parts
        self.study, self._sockets = study, []
        self._work = concurrent.futures.ThreadPoolExecutor(2)
        self._status = rospy.Subscriber(self.names.host + '/status', GoalStatusArray, self._on_status, queue_size=1)
        self._goal, self._cancel = (
            Outlet(f'{self.names.host}/{name}', kind, lambda: self._status.get_num_connections() > 0, queue_size=1)
            for name, kind in (('goal', MoveBaseActionGoal), ('cancel', GoalID)))
        self._elsewhere, self._unheard = [], None
        self.camera = Camera(options.camera, options.camera_info, self.robot)
        others = {'goals': lambda: self.goals.report(), 'record': self.recorder.report, 'tuning': self.tuning.report,
                  'camera': self.camera.report, 'study': lambda: study.report() if study else None, 'unheard': lambda: self._unheard,
                  'said': self.robot.said}
        self.scene = Scene(self.robot, self.tuning.parameters, others, regions)
        self.goals = Goals(self._send_goal, lambda: self._cancel.publish(GoalID()), self.scene.progress,
                           () if study else options.tour)
        self.desk = Desk(self, settings, time.monotonic, study is not None)
        self.feeds = foxglove.Feeds(foxglove.channels_of(self.names), self.robot.find, loop.add_callback)
        rospy.Subscriber(self.names.host + '/goal', MoveBaseActionGoal, self._on_goal, queue_size=10)
        rospy.Subscriber(self.names.host + '/result', MoveBaseActionResult, self._on_result, queue_size=10)

    # -- what the desk asks for

    def steer(self, command):
        """A command to the planner."""
        return self.device.steer(command)

    def stop(self, on):
        """A stop to the planner, or its end."""
        return self.device.stop(on)

    def input_timeout(self):
        """The planner's [s]."""
        return float(self.tuning.parameters().get('input_timeout', DEFAULT_TIMEOUT))

    def mode(self):
        """The planner's mode; None where there is no planner."""
        return self.scene.mode

    def in_control(self):
        """Whether the operator drives alone."""
        return self.scene.state_name == 'MANUAL' or (self.scene.state_name == 'LOST' and self.scene.mode == 'switching')

    def do(self, kind, fields):
        """A wish of the holder: (ok, text)."""
        now, goals, pose = time.monotonic(), self.goals, self.scene.pose
        if self.study and kind in ('mode', 'goal', 'home', 'skip', 'tune', 'preset', 'undo', 'record', 'cancel'):
            return False, 'in a study this is fixed'
        if kind in ('tune', 'undo', 'preset'):
            call = {'tune': lambda: self.tuning.tune(fields['values']), 'undo': self.tuning.undo,
                    'preset': lambda: self.tuning.preset(fields['name'])}[kind]
            self._later_told(kind, call)
            return True, 'asked'
        return {'mode': lambda: self._said(self.device.set_mode(fields['mode'])),
                'take_control': lambda: self._said(self.device.take_control(fields['on'])),
                'goal': lambda: self._to_host(goals.goal(fields['x'], fields['y'], fields['yaw'], fields['append'], pose, now)),
                'cancel': lambda: self._to_host(goals.cancel()), 'skip': lambda: self._to_host(goals.skip(now)),
                'home': lambda: self._to_host(goals.home(fields['append'], pose, now)),
                'record': lambda: self.recorder.record(fields['on']),
                'study': lambda: self.study.answer(fields['answer']) if self.study else (False, 'this is no study')}[kind]()

    @staticmethod
    def _said(unheard):
        return not unheard, unheard

    def _to_host(self, told):
        """What became of a wish about goals, where the host does not listen."""
        return told if not told[0] or self._goal.heard() else (False, f'nobody listens on {self._goal.topic}')

    def _find_unheard(self):
        """What of this page's nobody hears, for the page: the names, and a sentence with the remedy."""
        topics = self.device.unheard(self.mode())
        if not self._goal.heard():
            topics['goal'] = self._goal.topic
        if not topics:
            self._unheard = None
            return
        if 'stop' in topics:
            others = [name for name in self._elsewhere if name != self.names.planner]
            remedy = (f'A planner runs as {others[0]}: start the console with --planner {others[0]}' if others else
                      f'No planner runs as {self.names.planner}: start it, or give the console its name by --planner')
            text = f'{", ".join(topics)}. {remedy}'
        else:
            text = ', '.join(f'{what} (on {topic})' for what, topic in topics.items())
        self._unheard = {'what': list(topics), 'text': text}

    def _set_elsewhere(self, done):
        if not done.exception():
            self._elsewhere = done.result()

    def _later(self, call, then):
        """Runs what may block, and then `then(future)` in the server's thread."""
        self._work.submit(call).add_done_callback(lambda done: self.loop.add_callback(then, done))

    def _later_told(self, kind, call):
        """Runs what may block, and tells everybody at the controls how it ended."""
        self._later(call, lambda done: self._tell(kind, done))

    def _tell(self, kind, done):
        ok, text = (False, f'{done.exception()}') if done.exception() else done.result()
        self.desk.tell_holder({'type': 'told', 'what': kind, 'ok': ok, 'text': text})

    # -- sockets

    def enter(self, socket):
        """A socket opened; False where there are too many."""
        if len(self._sockets) >= server.MOST_SOCKETS:
            return False
        self._sockets.append(socket)
        return True

    def exit(self, socket):
        """A socket closed."""
        if socket in self._sockets:
            self._sockets.remove(socket)

    def later(self, delay, call):
        """Calls after a delay [s]."""
        self.loop.call_later(delay, call)

    def when_done(self, future, call):
        """Calls when a future is done, however it ended."""
        def done(ended):
            if not ended.cancelled():
                ended.exception()  # a connection that broke: its socket notices
            call()
        self.loop.add_future(future, done)

    @property
    def report_folder(self):
        """Where the last report is."""
        return self.recorder.report_folder

    # -- times

    def tick(self):
        """Twenty times a second."""
        self.desk.tick()
        views = [s for s in self._sockets if isinstance(s, server.ViewSocket)]
        ran = self.scene.state is not None
        self.scene.refresh(any(s.candidates for s in views))
        if self.scene.state is not None and not ran:
            self.desk.planner_runs()
        stopped = self.desk.stop_on is not None or self.scene.state_name == 'STOPPED'
        self.goals.see(self.scene.pose, time.monotonic(), stopped)
        for view in views:
            view.show(self.scene)
        for socket in self._sockets:
            if isinstance(socket, server.CameraSocket):
                socket.show(self.camera)

    def slow_tick(self):
        """Once a second."""
        self.recorder.tick()
        if self.study:
            self.study.tick()
        self.device.prepare()
        if self._unheard and 'stop' in self._unheard['what']:
            self._later(planners, self._set_elsewhere)
        self._find_unheard()

    def close(self):
        """The console ends: what it steers is released, a stop stays."""
        for socket in list(self._sockets):
            socket.end(1001, 'the console ends')
        self.desk.close()
        self.recorder.close()
        self._work.shutdown()

    # -- goals

    def _send_goal(self, number, pose):
        message = goal_message(pose, number, self.names.map_frame)
        self._goal.publish(message)

    def _on_goal(self, message):
        target = message.goal.target_pose
        q = target.pose.orientation
        pose = (target.pose.position.x, target.pose.position.y, float(yaw_of(q.x, q.y, q.z, q.w)))
        self.loop.add_callback(lambda: self.goals.seen(message.goal_id.id, pose, time.monotonic()))

    def _on_result(self, message):
        status = message.status
        self.loop.add_callback(lambda: self.goals.result(status.goal_id.id, status.status, status.text, time.monotonic()))

    def _on_status(self, message):
        known = [status.goal_id.id for status in message.status_list]
        self.loop.add_callback(lambda: self.goals.known(known))

    def foreign_goal(self, frame, x, y, yaw):
        """A goal of another program: it counts if no page holds the controls. (ok, text)"""
        if self.desk.holder() or self.study:
            return False, 'somebody holds the controls: the goal does not count'
        if frame != self.names.map_frame:
            return False, f'a goal in the frame {frame[:40]} does not count: give it in {self.names.map_frame}'
        return self.goals.goal(x, y, yaw, False, self.scene.pose, time.monotonic())
