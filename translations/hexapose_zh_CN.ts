<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>ChartWords</name>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>支腿</translation>
    </message>
    <message>
        <source>Position error</source>
        <translation>位置误差</translation>
    </message>
    <message>
        <source>Angle error</source>
        <translation>角度误差</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>Columns of the file</source>
        <translation>文件的列</translation>
    </message>
    <message>
        <source>Empty</source>
        <translation>空</translation>
    </message>
</context>
<context>
    <name>LogPlotWords</name>
    <message>
        <source>Row</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>时间，s</translation>
    </message>
    <message>
        <source>Time, s after %1</source>
        <translation>%1 之后的时间，s</translation>
    </message>
    <message>
        <source>This log has none of these columns</source>
        <translation>此日志没有这些列</translation>
    </message>
</context>
<context>
    <name>hexapose::Banner</name>
    <message>
        <source>Training the model of this platform; it is kept for the next time</source>
        <translation>正在训练该平台的模型，训练结果会保留供下次使用</translation>
    </message>
    <message>
        <source>Connection lost - reconnecting</source>
        <translation>连接已断开，正在重试</translation>
    </message>
    <message>
        <source>Connection lost: %1 - reconnecting</source>
        <translation>连接已断开：%1；正在重试</translation>
    </message>
    <message>
        <source>Waiting for the controller to answer</source>
        <translation>正在等待控制器应答</translation>
    </message>
    <message>
        <source>No valid measurement for %1 s: the values shown are old</source>
        <translation>已有 %1 s 没有有效测量值：显示的是旧值</translation>
    </message>
    <message>
        <source>The log cannot be written: %1</source>
        <translation>无法写入日志：%1</translation>
    </message>
    <message>
        <source>Listen-only source without checksums: transmission errors go unnoticed, and it takes no commands</source>
        <translation>无校验的只听数据源：传输错误无法发现，也不接受命令</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Cancel the training</source>
        <translation>取消训练</translation>
    </message>
    <message>
        <source>Training progress</source>
        <translation>训练进度</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Waiting for the first measurement</source>
        <translation>正在等待首个测量值</translation>
    </message>
    <message>
        <source>The control loop ended: %1. Disconnect and connect again.</source>
        <translation>控制循环已结束：%1。请断开后重新连接。</translation>
    </message>
    <message>
        <source>The log is not complete: %1</source>
        <translation>日志不完整：%1</translation>
    </message>
</context>
<context>
    <name>hexapose::ChartPage</name>
    <message>
        <source>Leg %1</source>
        <translation>支腿 %1</translation>
    </message>
    <message>
        <source>Error of %1</source>
        <translation>%1 误差</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>时间，s</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>位姿</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>支腿</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Shorter time window</source>
        <translation>缩短时间窗</translation>
    </message>
    <message>
        <source>Longer time window</source>
        <translation>延长时间窗</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>path</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>set-point</source>
        <translation>设定值</translation>
    </message>
</context>
<context>
    <name>hexapose::ChartSheet</name>
    <message>
        <source>Add curve</source>
        <translation>添加曲线</translation>
    </message>
    <message>
        <source>Remove curve</source>
        <translation>移除曲线</translation>
    </message>
    <message>
        <source>Add chart</source>
        <translation>添加图表</translation>
    </message>
    <message>
        <source>Remove chart</source>
        <translation>移除图表</translation>
    </message>
    <message>
        <source>Cursor A here</source>
        <translation>光标 A 放在这里</translation>
    </message>
    <message>
        <source>Cursor B here</source>
        <translation>光标 B 放在这里</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>显示全部</translation>
    </message>
    <message>
        <source>Export this chart...</source>
        <translation>导出此图表...</translation>
    </message>
</context>
<context>
    <name>hexapose::ColumnList</name>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Column list</source>
        <translation>列清单</translation>
    </message>
    <message>
        <source>Filter columns</source>
        <translation>筛选列</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Add to chart</source>
        <translation>添加到图表</translation>
    </message>
    <message>
        <source>Add the chosen columns to the present chart</source>
        <translation>将所选列添加到当前图表</translation>
    </message>
    <message>
        <source>New chart</source>
        <translation>新图表</translation>
    </message>
    <message>
        <source>Show the chosen columns in a chart of their own</source>
        <translation>在单独的图表中显示所选列</translation>
    </message>
    <message>
        <source>Not numbers: states and events are marked in every chart</source>
        <translation>不是数字：状态和事件标记在每个图表中</translation>
    </message>
</context>
<context>
    <name>hexapose::ConnectionPanel</name>
    <message>
        <source>Virtual platform</source>
        <translation>虚拟平台</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>The built-in virtual platform, or a serial port; any path can be typed</source>
        <translation>内置虚拟平台或串口；可输入任意路径</translation>
    </message>
    <message>
        <source>Baud rate</source>
        <translation>波特率</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>断开</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Stop, disable and close the port</source>
        <translation>停止、去使能并关闭端口</translation>
    </message>
    <message>
        <source>Open the port; nothing moves</source>
        <translation>打开端口；不会产生运动</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>回参考点</translation>
    </message>
    <message>
        <source>Find the reference of the legs</source>
        <translation>寻找各支腿的参考点</translation>
    </message>
    <message>
        <source>Disable</source>
        <translation>去使能</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>使能</translation>
    </message>
    <message>
        <source>Switch the drives off</source>
        <translation>关闭驱动器</translation>
    </message>
    <message>
        <source>Switch the drives on</source>
        <translation>打开驱动器</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>故障复位</translation>
    </message>
    <message>
        <source>Acknowledge the stop or fault (no motion)</source>
        <translation>确认停止或故障（不产生运动）</translation>
    </message>
    <message>
        <source>The solver cannot be changed while the platform moves.</source>
        <translation>平台运动时不能更换求解器。</translation>
    </message>
    <message>
        <source>The solver is being prepared.</source>
        <translation>正在准备求解器。</translation>
    </message>
    <message>
        <source>Method that computes the pose from the leg lengths.
MPR3-NR, MPR2-NR: regression, then Newton
Newton: iteration alone
FSI: follows the path of the legs in small steps
Changing it moves nothing.</source>
        <translation>由腿长求位姿的方法。
MPR3-NR、MPR2-NR：先回归，再用牛顿法修正
Newton：仅用牛顿迭代
FSI：以小步沿支腿路径跟踪
更换求解器不会引起运动。</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>求解器</translation>
    </message>
    <message>
        <source>Cannot connect: no port is named</source>
        <translation>无法连接：未填写端口</translation>
    </message>
    <message>
        <source>Cannot connect: baud rate: %1</source>
        <translation>无法连接：波特率：%1</translation>
    </message>
</context>
<context>
    <name>hexapose::Console</name>
    <message>
        <source>%1 of %2 named poses in the settings cannot be read and are left out</source>
        <translation>设置中的 %2 个已命名位姿有 %1 个无法读取，已略去</translation>
    </message>
    <message>
        <source>The training of the model was cancelled</source>
        <translation>模型训练已取消</translation>
    </message>
    <message>
        <source>The model could not be trained: %1</source>
        <translation>模型无法训练：%1</translation>
    </message>
    <message>
        <source>Newton&apos;s method is used in its place.</source>
        <translation>改用牛顿法。</translation>
    </message>
    <message>
        <source>The solver stays as it was.</source>
        <translation>求解器保持不变。</translation>
    </message>
</context>
<context>
    <name>hexapose::CursorTable</name>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>Sigma</source>
        <translation>标准差</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>均方根</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>个数</translation>
    </message>
    <message>
        <source>Cursor table</source>
        <translation>光标表</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲线</translation>
    </message>
</context>
<context>
    <name>hexapose::EventList</name>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
</context>
<context>
    <name>hexapose::EventText</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>已连接</translation>
    </message>
    <message>
        <source>Listen-only source without checksums</source>
        <translation>无校验的只听数据源</translation>
    </message>
    <message>
        <source>Its values are shown, but it takes no commands, and transmission errors go unnoticed.</source>
        <translation>其数值会显示，但它不接受命令，传输错误也无法发现。</translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation>连接已断开</translation>
    </message>
    <message>
        <source>Check the cable and the port; the console keeps trying.</source>
        <translation>请检查电缆和端口；控制台会持续重试。</translation>
    </message>
    <message>
        <source>No valid measurement for %1 ms</source>
        <translation>已有 %1 ms 没有有效测量值</translation>
    </message>
    <message>
        <source>The values shown are old. Check the controller and the line.</source>
        <translation>显示的是旧值。请检查控制器和线路。</translation>
    </message>
    <message>
        <source>The controller&apos;s clock went back</source>
        <translation>控制器时钟回退</translation>
    </message>
    <message>
        <source>It was probably restarted. Reference it again if it asks for it.</source>
        <translation>控制器可能已重启。如有要求，请重新回参考点。</translation>
    </message>
    <message>
        <source>The controller did not answer</source>
        <translation>控制器未应答</translation>
    </message>
    <message>
        <source>Try again; if it stays silent, check the controller and the line.</source>
        <translation>请重试；若仍无应答，请检查控制器和线路。</translation>
    </message>
    <message>
        <source>Find the cause, press Clear, then Run.</source>
        <translation>请查明原因，按“故障复位”，再按“运行”。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Press Clear before the next Run.</source>
        <translation>再次运行前请先按“故障复位”。</translation>
    </message>
    <message>
        <source>The controller stopped the move</source>
        <translation>控制器停止了运动</translation>
    </message>
    <message>
        <source>Stopped: no measurements received</source>
        <translation>已停止：未收到测量值</translation>
    </message>
    <message>
        <source>Stopped: the lengths gave no usable pose</source>
        <translation>已停止：腿长得不到可用的位姿</translation>
    </message>
    <message>
        <source>Stopped: the controller refused a set-point</source>
        <translation>已停止：控制器拒绝了设定值</translation>
    </message>
    <message>
        <source>The control loop ended: %1</source>
        <translation>控制循环已结束：%1</translation>
    </message>
    <message>
        <source>Disconnect and connect again; report the error with its log.</source>
        <translation>请断开后重新连接；并附上日志报告此错误。</translation>
    </message>
    <message>
        <source>Controller fault</source>
        <translation>控制器故障</translation>
    </message>
    <message>
        <source>Remove the cause at the machine, then press Clear.</source>
        <translation>请在设备上排除故障，再按“故障复位”。</translation>
    </message>
    <message>
        <source>The move was refused</source>
        <translation>运动被拒绝</translation>
    </message>
    <message>
        <source>Nothing moved. Change the target.</source>
        <translation>未产生运动。请修改目标。</translation>
    </message>
    <message>
        <source>The move did not start: referencing or enabling failed</source>
        <translation>运动未开始：回参考点或使能失败</translation>
    </message>
    <message>
        <source>Press Reference or Enable and see what the controller answers.</source>
        <translation>请按“回参考点”或“使能”，查看控制器的应答。</translation>
    </message>
    <message>
        <source>The controller refused</source>
        <translation>控制器拒绝</translation>
    </message>
    <message>
        <source>See the controller&apos;s manual for the code.</source>
        <translation>请在控制器手册中查找该代码。</translation>
    </message>
    <message>
        <source>The command cannot be carried out in this state</source>
        <translation>当前状态下无法执行该命令</translation>
    </message>
    <message>
        <source>After a stop or a fault press Clear first.</source>
        <translation>停止或故障后请先按“故障复位”。</translation>
    </message>
    <message>
        <source>The legs had not settled after %1 s</source>
        <translation>各支腿在 %1 s 后仍未稳定</translation>
    </message>
    <message>
        <source>Look at the leg errors: load, friction or a drive&apos;s gain may be the cause.</source>
        <translation>请查看支腿误差：原因可能是负载、摩擦或驱动器增益。</translation>
    </message>
    <message>
        <source>The log cannot be written</source>
        <translation>无法写入日志</translation>
    </message>
    <message>
        <source>Free space on the disk, then connect again.</source>
        <translation>请释放磁盘空间，然后重新连接。</translation>
    </message>
    <message>
        <source>Referencing the legs</source>
        <translation>各支腿正在回参考点</translation>
    </message>
    <message>
        <source>The legs are referenced</source>
        <translation>各支腿已回参考点</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>已使能</translation>
    </message>
    <message>
        <source>Disabled</source>
        <translation>已去使能</translation>
    </message>
    <message>
        <source>Settled after %1 s</source>
        <translation>%1 s 后稳定</translation>
    </message>
    <message>
        <source>Cleared</source>
        <translation>已故障复位</translation>
    </message>
    <message>
        <source>Press Run when it is safe to move.</source>
        <translation>确认可安全运动后按“运行”。</translation>
    </message>
    <message>
        <source>Sample %1 of the report taken</source>
        <translation>已取得报告样本 %1</translation>
    </message>
    <message>
        <source>Receiving measurements</source>
        <translation>正在接收测量值</translation>
    </message>
    <message>
        <source>Stopped: the controller accepted no set-point for %1 ms</source>
        <translation>已停止：控制器在 %1 ms 内未接受任何设定值</translation>
    </message>
    <message>
        <source>Stopped at a limit</source>
        <translation>已在限值处停止</translation>
    </message>
    <message>
        <source>Stopped: the controller gave another name or other limits</source>
        <translation>已停止：控制器给出了不同的名称或限位</translation>
    </message>
    <message>
        <source>Connection restored after a loss during a move: a stop was sent</source>
        <translation>运动中断开的连接已恢复：已发送停止命令</translation>
    </message>
    <message>
        <source>The controller did not confirm that the drives are off</source>
        <translation>控制器未确认驱动已关闭</translation>
    </message>
    <message>
        <source>Check the machine; switch its drives off there.</source>
        <translation>请查看设备，并在设备上关闭驱动。</translation>
    </message>
    <message>
        <source>Stopped: a leg does not follow</source>
        <translation>已停止：支腿未跟随</translation>
    </message>
    <message>
        <source>Wait until the motion is over.</source>
        <translation>请等待运动结束。</translation>
    </message>
    <message>
        <source>Press Enable first; a jog does not switch the drives on.</source>
        <translation>请先按“使能”；点动不会打开驱动。</translation>
    </message>
    <message>
        <source>Wait until the motion is over, or press Stop.</source>
        <translation>请等待运动结束，或按“停止”。</translation>
    </message>
    <message>
        <source>Nothing moved. Go there in smaller steps or in the other mode.</source>
        <translation>未产生运动。请分小步到达，或改用另一种模式。</translation>
    </message>
    <message>
        <source>The jog stopped before a limit</source>
        <translation>点动在极限前停下</translation>
    </message>
    <message>
        <source>Jog the other way, or along another axis.</source>
        <translation>请反向点动，或沿其他轴点动。</translation>
    </message>
    <message>
        <source>Jog started</source>
        <translation>点动开始</translation>
    </message>
    <message>
        <source>The solver is now %1</source>
        <translation>当前求解器为 %1</translation>
    </message>
    <message>
        <source>Wait until a controller is connected.</source>
        <translation>请等待控制器连接。</translation>
    </message>
    <message>
        <source>There is nothing to resume.</source>
        <translation>没有可继续的运动。</translation>
    </message>
    <message>
        <source>Nothing has changed.</source>
        <translation>没有任何改变。</translation>
    </message>
    <message>
        <source>Nothing moved. Try again.</source>
        <translation>未产生运动。请重试。</translation>
    </message>
    <message>
        <source>Move started: %1 s at full speed</source>
        <translation>运动开始：全速时 %1 s</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>internal error &quot;%1&quot;</source>
        <translation>内部错误“%1”</translation>
    </message>
    <message>
        <source>Leave the log in its place until you disconnect.</source>
        <translation>断开之前请勿移动或删除日志文件。</translation>
    </message>
    <message>
        <source>The log was deleted; all of it is in %1 now</source>
        <translation>日志文件已被删除；全部内容已重新写入 %1</translation>
    </message>
    <message>
        <source>The log was moved or replaced; it goes on in %1</source>
        <translation>日志文件已被移动或替换；后续内容写入 %1</translation>
    </message>
    <message>
        <source>The log goes on in %1</source>
        <translation>日志后续内容写入 %1</translation>
    </message>
    <message>
        <source>Little space is left for the log</source>
        <translation>日志的剩余磁盘空间不足</translation>
    </message>
    <message>
        <source>Free space on the disk.</source>
        <translation>请释放磁盘空间。</translation>
    </message>
</context>
<context>
    <name>hexapose::GuidedTestPanel</name>
    <message>
        <source>Guided test</source>
        <translation>引导测试</translation>
    </message>
    <message>
        <source>Go to the pose of the published test, wait until it has settled, average the lengths for 1 s, solve and compare; the platform moves</source>
        <translation>运动到论文实验的位姿，等待稳定，将腿长平均 1 s，求解并比较；平台会运动</translation>
    </message>
    <message>
        <source>Move to the pose</source>
        <translation>运动到测试位姿</translation>
    </message>
    <message>
        <source>Wait until it has settled</source>
        <translation>等待稳定</translation>
    </message>
    <message>
        <source>Average the lengths for 1 s</source>
        <translation>将腿长平均 1 s</translation>
    </message>
    <message>
        <source>Solve and compare</source>
        <translation>求解并比较</translation>
    </message>
    <message>
        <source>target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>expected</source>
        <translation>预期</translation>
    </message>
    <message>
        <source>The largest error that the 0.1 mm resolution of the lengths explains</source>
        <translation>由 0.1 mm 腿长分辨率所能解释的最大误差</translation>
    </message>
    <message>
        <source>mean lengths, mm</source>
        <translation>平均腿长，mm</translation>
    </message>
    <message>
        <source>Test target %1</source>
        <translation>测试目标 %1</translation>
    </message>
    <message>
        <source>Test measured %1</source>
        <translation>测试实测 %1</translation>
    </message>
    <message>
        <source>Test error %1</source>
        <translation>测试误差 %1</translation>
    </message>
    <message>
        <source>Test expected error %1</source>
        <translation>测试预期误差 %1</translation>
    </message>
    <message>
        <source>Test length %1</source>
        <translation>测试腿长 %1</translation>
    </message>
    <message>
        <source>Test progress</source>
        <translation>测试进度</translation>
    </message>
    <message>
        <source>Moves to the pose of the published test, measures it and compares</source>
        <translation>运动到论文实验的位姿，测量并比较</translation>
    </message>
    <message>
        <source>Ended: the connection was closed</source>
        <translation>已结束：连接已关闭</translation>
    </message>
    <message>
        <source>No pose of this test can be reached from here. Nothing moved.</source>
        <translation>从当前位姿无法到达此测试的任何位姿。未产生运动。</translation>
    </message>
    <message>
        <source>The test is under way; Stop ends it</source>
        <translation>测试进行中；按“停止”可结束</translation>
    </message>
    <message>
        <source>Ended early: %1</source>
        <translation>提前结束：%1</translation>
    </message>
    <message>
        <source>Done: %1 measurements averaged; solution: %2</source>
        <translation>完成：已平均 %1 次测量；求解：%2</translation>
    </message>
    <message>
        <source>Ended by Stop. Press Clear before the next one.</source>
        <translation>已由“停止”结束。下次测试前请先按“故障复位”。</translation>
    </message>
    <message>
        <source>The platform is not ready any more. Nothing moved.</source>
        <translation>平台已不再就绪。未产生运动。</translation>
    </message>
</context>
<context>
    <name>hexapose::InputFaultText</name>
    <message>
        <source>exists already</source>
        <translation>已存在</translation>
    </message>
    <message>
        <source>cannot be created: %1</source>
        <translation>无法创建：%1</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>无法写入：%1</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>无法读取：%1</translation>
    </message>
    <message>
        <source>cannot be read further</source>
        <translation>无法继续读取</translation>
    </message>
    <message>
        <source>is a directory</source>
        <translation>是一个目录</translation>
    </message>
    <message>
        <source>is empty, a header row was expected</source>
        <translation>为空，应有表头行</translation>
    </message>
    <message>
        <source>a quote is opened and never closed</source>
        <translation>引号未闭合</translation>
    </message>
    <message>
        <source>is not UTF-8 text</source>
        <translation>不是 UTF-8 文本</translation>
    </message>
    <message>
        <source>column %1 is missing</source>
        <translation>缺少列 %1</translation>
    </message>
    <message>
        <source>column %1 is missing; separate the fields by commas</source>
        <translation>缺少列 %1；请用逗号分隔各字段</translation>
    </message>
    <message>
        <source>column %1 appears twice</source>
        <translation>列 %1 出现了两次</translation>
    </message>
    <message>
        <source>the last line is incomplete</source>
        <translation>最后一行不完整</translation>
    </message>
    <message>
        <source>%1 fields, but the header has %2</source>
        <translation>有 %1 个字段，但表头有 %2 个</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot; is not a finite number</source>
        <translation>%1 的值“%2”不是有限数值</translation>
    </message>
    <message>
        <source>the list holds no poses</source>
        <translation>列表中没有位姿</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1，第 %2 行：%3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>hexapose::JogPanel</name>
    <message>
        <source>Moves while a button is held. Keys, with the focus here: arrows for x and y, page up and down for z; hold Shift to rotate about the axis</source>
        <translation>按住按钮时运动。焦点在此处时可用键盘：方向键为 x 和 y，PgUp/PgDn 为 z；按住 Shift 则绕该轴转动</translation>
    </message>
    <message>
        <source>One step per click or key: arrows for x and y, page up and down for z; hold Shift to rotate about the axis</source>
        <translation>每次点击或按键走一步：方向键为 x 和 y，PgUp/PgDn 为 z；按住 Shift 则绕该轴转动</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>Jog frame</source>
        <translation>点动坐标系</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基座</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>平台</translation>
    </message>
    <message>
        <source>Along and about the axes of the base, or those of the platform in its present orientation</source>
        <translation>沿基座各轴，或沿平台当前姿态的各轴移动和转动</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步长</translation>
    </message>
    <message>
        <source>Jog step</source>
        <translation>点动步长</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>按住</translation>
    </message>
    <message>
        <source>Hold: moves as long as a button is held. A number: moves by this many mm or degrees per click</source>
        <translation>按住：按住按钮期间一直运动。数值：每次点击运动的毫米数或度数</translation>
    </message>
    <message>
        <source>Jog keys</source>
        <translation>点动按键区</translation>
    </message>
    <message>
        <source>Keys, with the focus here: left and right x, down and up y, page down and page up z; hold Shift for alpha, beta, gamma. Letting go ends the motion.</source>
        <translation>焦点在此处时可用键盘：左右键 x，下上键 y，PgDn/PgUp z；按住 Shift 为 alpha、beta、gamma。松开即停止运动。</translation>
    </message>
    <message>
        <source>Jog -%1</source>
        <translation>点动 -%1</translation>
    </message>
    <message>
        <source>Jog +%1</source>
        <translation>点动 +%1</translation>
    </message>
    <message>
        <source>How far it can go in this direction from the present pose</source>
        <translation>从当前位姿沿此方向还能运动多远</translation>
    </message>
    <message>
        <source>Jog hint</source>
        <translation>点动提示</translation>
    </message>
    <message>
        <source>range left</source>
        <translation>剩余范围</translation>
    </message>
    <message>
        <source>Connect first; a jog needs the drives on</source>
        <translation>请先连接；点动需要驱动打开</translation>
    </message>
    <message>
        <source>Press Reference and Enable first; a jog needs the drives on</source>
        <translation>请先按“回参考点”和“使能”；点动需要驱动打开</translation>
    </message>
    <message>
        <source>Press Clear and Enable first; a jog needs the drives on</source>
        <translation>请先按“故障复位”和“使能”；点动需要驱动打开</translation>
    </message>
    <message>
        <source>Press Enable first; a jog needs the drives on</source>
        <translation>请先按“使能”；点动需要驱动打开</translation>
    </message>
    <message>
        <source>Wait until the motion is over, or press Stop</source>
        <translation>请等待运动结束，或按“停止”</translation>
    </message>
    <message>
        <source>That step was not taken: the one before was still under way. Press again.</source>
        <translation>该步未执行：上一步仍在进行中。请再按一次。</translation>
    </message>
</context>
<context>
    <name>hexapose::LegsPanel</name>
    <message>
        <source>Legs</source>
        <translation>支腿</translation>
    </message>
    <message>
        <source>set-point, mm</source>
        <translation>设定值，mm</translation>
    </message>
    <message>
        <source>measured, mm</source>
        <translation>实测，mm</translation>
    </message>
    <message>
        <source>error, mm</source>
        <translation>误差，mm</translation>
    </message>
    <message>
        <source>within the stroke</source>
        <translation>行程内位置</translation>
    </message>
    <message>
        <source>Leg %1 set-point</source>
        <translation>支腿 %1 设定值</translation>
    </message>
    <message>
        <source>Leg %1 measured</source>
        <translation>支腿 %1 实测值</translation>
    </message>
    <message>
        <source>Leg %1 error</source>
        <translation>支腿 %1 误差</translation>
    </message>
    <message>
        <source>Leg %1 within its stroke</source>
        <translation>支腿 %1 行程内位置</translation>
    </message>
</context>
<context>
    <name>hexapose::LogChart</name>
    <message>
        <source>Chart %1</source>
        <translation>图表 %1</translation>
    </message>
</context>
<context>
    <name>hexapose::LogSummary</name>
    <message>
        <source>%1 rows</source>
        <translation>%1 行</translation>
    </message>
    <message>
        <source>No log</source>
        <translation>没有日志</translation>
    </message>
    <message>
        <source>Open a log, or drop one here.</source>
        <translation>打开日志，或将文件拖放到这里。</translation>
    </message>
    <message>
        <source>%1 of %2 MB, %3 rows</source>
        <translation>%1 / %2 MB，%3 行</translation>
    </message>
    <message>
        <source>Cancelled: only the first part was read</source>
        <translation>已取消：只读取了前面一部分</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行数</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Time span</source>
        <translation>时间范围</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>读取</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Stop reading and keep what there is</source>
        <translation>停止读取，保留已读部分</translation>
    </message>
</context>
<context>
    <name>hexapose::LookMenu</name>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>主题(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>深色(&amp;D)</translation>
    </message>
</context>
<context>
    <name>hexapose::MotionCheckText</name>
    <message>
        <source>Leg %1 would be %2 mm, above its maximum %3 mm (by %4 mm)</source>
        <translation>支腿 %1 将为 %2 mm，超过上限 %3 mm（超出 %4 mm）</translation>
    </message>
    <message>
        <source>Leg %1 would be %2 mm, below its minimum %3 mm (by %4 mm)</source>
        <translation>支腿 %1 将为 %2 mm，低于下限 %3 mm（差 %4 mm）</translation>
    </message>
    <message>
        <source>Reachable</source>
        <translation>可到达</translation>
    </message>
    <message>
        <source>A coordinate is not a number</source>
        <translation>有坐标不是数字</translation>
    </message>
    <message>
        <source>Too close to a singular pose: margin %1, at least %2 is needed</source>
        <translation>过于接近奇异位姿：裕度 %1，至少需要 %2</translation>
    </message>
    <message>
        <source>The legs would reach another pose than the target</source>
        <translation>支腿会导向与目标不同的位姿</translation>
    </message>
    <message>
        <source>Leg %1 would be above its maximum</source>
        <translation>支腿 %1 将超过上限</translation>
    </message>
    <message>
        <source>Leg %1 would be below its minimum</source>
        <translation>支腿 %1 将低于下限</translation>
    </message>
    <message>
        <source>Too close to a singular pose</source>
        <translation>过于接近奇异位姿</translation>
    </message>
    <message>
        <source>%1 would be %2, outside its allowed ±%3</source>
        <translation>%1 将为 %2，超出允许的 ±%3</translation>
    </message>
    <message>
        <source>Leg %1 would move at %2 mm/s, above its limit of %3 mm/s</source>
        <translation>支腿 %1 速度将为 %2 mm/s，超过其限值 %3 mm/s</translation>
    </message>
    <message>
        <source>Leg %1 would accelerate by %2 mm/s², above its limit of %3 mm/s²</source>
        <translation>支腿 %1 加速度将为 %2 mm/s²，超过其限值 %3 mm/s²</translation>
    </message>
    <message>
        <source>The path comes too close to a singular pose</source>
        <translation>路径过于接近奇异位姿</translation>
    </message>
    <message>
        <source>Beyond the singular poses: q would be %1, at least %2 is needed</source>
        <translation>越过奇异位姿：q 将为 %1，至少需要 %2</translation>
    </message>
    <message>
        <source>Leg %1 would exceed its speed limit</source>
        <translation>支腿 %1 将超过其速度极限</translation>
    </message>
    <message>
        <source>%1 would be outside its allowed range</source>
        <translation>%1 将超出允许范围</translation>
    </message>
    <message>
        <source>Beyond the singular poses</source>
        <translation>越过奇异位姿</translation>
    </message>
    <message>
        <source>%1, at %2 % of the path</source>
        <translation>%1（位于路径 %2 % 处）</translation>
    </message>
    <message>
        <source>Leg %1 would exceed its acceleration limit</source>
        <translation>支腿 %1 将超过其加速度极限</translation>
    </message>
    <message>
        <source>The path runs along a singular pose, or is too long to be checked in time</source>
        <translation>路径贴近奇异位姿，或过长而无法及时检查</translation>
    </message>
    <message>
        <source>The platform has moved since the motion was planned</source>
        <translation>规划之后平台已移动</translation>
    </message>
    <message>
        <source>The limits have changed since the motion was planned</source>
        <translation>规划之后限值已改变</translation>
    </message>
</context>
<context>
    <name>hexapose::MotionPanel</name>
    <message>
        <source>Motion</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>关节空间</translation>
    </message>
    <message>
        <source>Workspace</source>
        <translation>工作空间</translation>
    </message>
    <message>
        <source>Joint: each leg changes its length steadily. Workspace: the platform moves in a straight line, corrected by its measured pose. Changing it moves nothing.</source>
        <translation>关节空间：各支腿长度平稳变化。工作空间：平台沿直线运动，以实测位姿校正。切换模式不会产生运动。</translation>
    </message>
    <message>
        <source>Motion pages</source>
        <translation>运动方式</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>Way-points</source>
        <translation>路径点</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>Stop  (Esc)</source>
        <translation>停止 (Esc)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stop the motion (Esc). This is not the emergency stop of the machine.</source>
        <translation>停止运动（Esc）。这不是设备的急停。</translation>
    </message>
</context>
<context>
    <name>hexapose::NamedPoses</name>
    <message>
        <source>Pose name</source>
        <translation>位姿名称</translation>
    </message>
    <message>
        <source>Named poses</source>
        <translation>已命名的位姿</translation>
    </message>
    <message>
        <source>Choose a pose to load it into the fields, or type a name to save them under</source>
        <translation>选择一个位姿填入各字段，或输入名称以保存当前字段</translation>
    </message>
    <message>
        <source>Save pose</source>
        <translation>保存位姿</translation>
    </message>
    <message>
        <source>Save the fields under this name (no motion)</source>
        <translation>以此名称保存各字段，不产生任何运动</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Remove pose</source>
        <translation>删除位姿</translation>
    </message>
    <message>
        <source>Delete this pose</source>
        <translation>删除该位姿</translation>
    </message>
</context>
<context>
    <name>hexapose::NumberField</name>
    <message>
        <source>nothing typed</source>
        <translation>未填写</translation>
    </message>
    <message>
        <source>unfinished</source>
        <translation>未输完</translation>
    </message>
    <message>
        <source>contains a space</source>
        <translation>中间有空格</translation>
    </message>
    <message>
        <source>two decimal marks</source>
        <translation>多个小数点</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>不是数字</translation>
    </message>
    <message>
        <source>too large or too small</source>
        <translation>过大或过小</translation>
    </message>
    <message>
        <source>beyond ±%1</source>
        <translation>超出 ±%1</translation>
    </message>
    <message>
        <source>not in %1 .. %2</source>
        <translation>须在 %1 .. %2 内</translation>
    </message>
    <message>
        <source>not a whole number</source>
        <translation>不是整数</translation>
    </message>
</context>
<context>
    <name>hexapose::OperatorWindow</name>
    <message>
        <source>The log cannot be created, so nothing was connected: %1</source>
        <translation>无法创建日志，因此未连接：%1</translation>
    </message>
    <message>
        <source>Free space or choose another folder with --log-dir.</source>
        <translation>请释放磁盘空间，或用 --log-dir 另选文件夹。</translation>
    </message>
    <message>
        <source>Close Hexapose</source>
        <translation>关闭 Hexapose</translation>
    </message>
    <message>
        <source>The platform is enabled. Stop it, disable it and close?</source>
        <translation>平台已使能。是否停止、去使能并关闭？</translation>
    </message>
    <message>
        <source>Stop, disable and close</source>
        <translation>停止、去使能并关闭</translation>
    </message>
    <message>
        <source>Keep running</source>
        <translation>继续运行</translation>
    </message>
    <message>
        <source>Hexapose</source>
        <translation>Hexapose</translation>
    </message>
    <message>
        <source>Console</source>
        <translation>控制台</translation>
    </message>
    <message>
        <source>Charts, legs and pose</source>
        <translation>曲线、支腿与位姿</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>The error report and its samples</source>
        <translation>误差报告及其样本</translation>
    </message>
    <message>
        <source>Export report</source>
        <translation>导出报告</translation>
    </message>
    <message>
        <source>Write report.pdf, errors.csv, errors.png and errors.svg</source>
        <translation>写出 report.pdf、errors.csv、errors.png 和 errors.svg</translation>
    </message>
</context>
<context>
    <name>hexapose::PayloadText</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>the sweep names no axis</source>
        <translation>扫频未指定坐标轴</translation>
    </message>
    <message>
        <source>the amplitude of the sweep is not above zero</source>
        <translation>扫频幅值必须大于零</translation>
    </message>
    <message>
        <source>a frequency of the sweep is below zero</source>
        <translation>扫频频率不得小于零</translation>
    </message>
    <message>
        <source>the duration of the sweep is not above zero</source>
        <translation>扫频时长必须大于零</translation>
    </message>
    <message>
        <source>no controller is connected</source>
        <translation>未连接控制器</translation>
    </message>
    <message>
        <source>the controller has not confirmed the stop yet</source>
        <translation>控制器尚未确认停止</translation>
    </message>
    <message>
        <source>a length is not a positive number</source>
        <translation>有长度不是正数</translation>
    </message>
    <message>
        <source>it speaks protocol version %1, not 1</source>
        <translation>其协议版本为 %1，而不是 1</translation>
    </message>
    <message>
        <source>it has %1 legs, not 6</source>
        <translation>它有 %1 条支腿，而不是 6 条</translation>
    </message>
    <message>
        <source>a field of its identity cannot be read, or is out of range</source>
        <translation>其标识中有字段无法读取或超出范围</translation>
    </message>
    <message>
        <source>there is no such port</source>
        <translation>没有该端口</translation>
    </message>
    <message>
        <source>this is not a serial port</source>
        <translation>这不是串口</translation>
    </message>
    <message>
        <source>no permission; add yourself to the group of serial ports (%1), then log in again</source>
        <translation>没有权限；请将自己加入串口用户组（%1），然后重新登录</translation>
    </message>
    <message>
        <source>another program has the port open</source>
        <translation>端口已被其他程序打开</translation>
    </message>
    <message>
        <source>the port cannot be opened (%1)</source>
        <translation>无法打开端口（%1）</translation>
    </message>
    <message>
        <source>the port is gone</source>
        <translation>端口已消失</translation>
    </message>
    <message>
        <source>the port accepts no more bytes</source>
        <translation>端口不再接收数据</translation>
    </message>
    <message>
        <source>the port is closed</source>
        <translation>端口已关闭</translation>
    </message>
    <message>
        <source>the last measurement is too old</source>
        <translation>最近的测量值太旧</translation>
    </message>
    <message>
        <source>disabling was commanded</source>
        <translation>已下达去使能指令</translation>
    </message>
    <message>
        <source>leg %1 is %2 mm from its set-point, more than %3 mm</source>
        <translation>支腿 %1 与设定值相差 %2 mm，超过 %3 mm</translation>
    </message>
    <message>
        <source>leg %1 is %2 mm off the path, more than %3 mm</source>
        <translation>支腿 %1 偏离路径 %2 mm，超过 %3 mm</translation>
    </message>
    <message>
        <source>leg %1 is %2 mm off the path, and the motion makes no progress</source>
        <translation>支腿 %1 偏离路径 %2 mm，且运动没有进展</translation>
    </message>
    <message>
        <source>%1 did not finish in time</source>
        <translation>%1未及时完成</translation>
    </message>
    <message>
        <source>%1: not answered</source>
        <translation>%1：未应答</translation>
    </message>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1 至 %2 mm</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>%1 rows were lost</source>
        <translation>丢失了 %1 行</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>回参考点</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>使能</translation>
    </message>
    <message>
        <source>Disable</source>
        <translation>去使能</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>故障复位</translation>
    </message>
    <message>
        <source>Set-point</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>Feedback period</source>
        <translation>反馈周期</translation>
    </message>
    <message>
        <source>Identification</source>
        <translation>识别</translation>
    </message>
    <message>
        <source>Unknown state</source>
        <translation>未知状态</translation>
    </message>
    <message>
        <source>%1 GB, enough for %2 min</source>
        <translation>%1 GB，可记录 %2 分钟</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 GB</translation>
    </message>
</context>
<context>
    <name>hexapose::PosePanel</name>
    <message>
        <source>Pose</source>
        <translation>位姿</translation>
    </message>
    <message>
        <source>path</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>expected</source>
        <translation>预期</translation>
    </message>
    <message>
        <source>The largest error that the 0.1 mm resolution of the lengths explains</source>
        <translation>由 0.1 mm 腿长分辨率所能解释的最大误差</translation>
    </message>
    <message>
        <source>Path %1</source>
        <translation>路径 %1</translation>
    </message>
    <message>
        <source>Measured %1</source>
        <translation>实测 %1</translation>
    </message>
    <message>
        <source>Error %1</source>
        <translation>误差 %1</translation>
    </message>
    <message>
        <source>Expected error %1</source>
        <translation>预期误差 %1</translation>
    </message>
    <message>
        <source>Singularity margin q</source>
        <translation>奇异裕度 q</translation>
    </message>
    <message>
        <source>Singularity margin bar</source>
        <translation>奇异裕度条</translation>
    </message>
    <message>
        <source>Distance from a singular pose: 1 at home, 0 where the platform cannot be held. Amber below 0.2, red below 0.05.</source>
        <translation>与奇异位姿的距离：零位为 1，平台无法保持处为 0。低于 0.2 为琥珀色，低于 0.05 为红色。</translation>
    </message>
</context>
<context>
    <name>hexapose::ProblemPanel</name>
    <message>
        <source>Problems: none</source>
        <translation>问题：无</translation>
    </message>
    <message>
        <source>Problems: %1</source>
        <translation>问题：%1</translation>
    </message>
    <message>
        <source>%1 rows left out, %2 cells missing</source>
        <translation>略去 %1 行，缺失 %2 个单元格</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Text of the line</source>
        <translation>该行文本</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number; the cell is missing</source>
        <translation>“%1”不是数字；该单元格缺失</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time; the row has none</source>
        <translation>“%1”不是时间；该行没有时间</translation>
    </message>
    <message>
        <source>%1 fields in place of %2; the row is left out</source>
        <translation>应有 %2 个字段，只有 %1 个；该行略去</translation>
    </message>
    <message>
        <source>%1 fields in place of %2, too many; the row is left out</source>
        <translation>应有 %2 个字段，却有 %1 个；该行略去</translation>
    </message>
    <message>
        <source>half-written last line, left out</source>
        <translation>最后一行未写完，略去</translation>
    </message>
    <message>
        <source>a quote is not closed; the line is left out</source>
        <translation>引号没有闭合；该行略去</translation>
    </message>
    <message>
        <source>time goes back; the row is kept</source>
        <translation>时间倒退；该行保留</translation>
    </message>
    <message>
        <source>the same time again; the row is kept</source>
        <translation>时间重复；该行保留</translation>
    </message>
    <message>
        <source>this name appears twice; the column is called &quot;%1&quot;</source>
        <translation>此名称出现两次；该列改称“%1”</translation>
    </message>
    <message>
        <source>a column without a name is called &quot;%1&quot;</source>
        <translation>没有名称的列称为“%1”</translation>
    </message>
    <message>
        <source>the line is too long and is left out</source>
        <translation>该行过长，略去</translation>
    </message>
    <message>
        <source>the file became shorter while it was read</source>
        <translation>读取时文件变短了</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>第 %1 行</translation>
    </message>
</context>
<context>
    <name>hexapose::ReadOut</name>
    <message>
        <source>Old value</source>
        <translation>旧值</translation>
    </message>
</context>
<context>
    <name>hexapose::ReportPanel</name>
    <message>
        <source>The list of poses cannot be used: %1</source>
        <translation>无法使用该位姿列表：%1</translation>
    </message>
    <message>
        <source>Correct the file, or choose another.</source>
        <translation>请修正该文件，或另选文件。</translation>
    </message>
    <message>
        <source>There is no settled pose to report yet</source>
        <translation>尚无已稳定的位姿可供报告</translation>
    </message>
    <message>
        <source>Press Run or Run report; the files are written once the first has settled.</source>
        <translation>请按“运行”或“运行报告”；首个位姿稳定后即写出文件。</translation>
    </message>
    <message>
        <source>Report written to %1</source>
        <translation>报告已写入 %1</translation>
    </message>
    <message>
        <source>The report cannot be written: %1</source>
        <translation>无法写出报告：%1</translation>
    </message>
    <message>
        <source>Choose another folder.</source>
        <translation>请另选文件夹。</translation>
    </message>
    <message>
        <source>List of poses</source>
        <translation>位姿列表</translation>
    </message>
    <message>
        <source>Poses (*.csv);;All files (*)</source>
        <translation>位姿 (*.csv);;所有文件 (*)</translation>
    </message>
    <message>
        <source>%1 of %2 poses done</source>
        <translation>已完成 %1 / %2 个位姿</translation>
    </message>
    <message>
        <source>Ended early: %1</source>
        <translation>提前结束：%1</translation>
    </message>
    <message>
        <source>Each settled Run becomes a sample too: 1 s of lengths, averaged, solved and compared with its target.</source>
        <translation>每次稳定后的运行也成为一个样本：取 1 s 腿长平均，求解后与目标比较。</translation>
    </message>
    <message>
        <source>Folder of the report</source>
        <translation>报告文件夹</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>位姿</translation>
    </message>
    <message>
        <source>10 at random, within 10 mm and 10°</source>
        <translation>随机 10 个，±10 mm、±10° 以内</translation>
    </message>
    <message>
        <source>From CSV...</source>
        <translation>从 CSV…</translation>
    </message>
    <message>
        <source>Columns x_mm, y_mm, z_mm, alpha_deg, beta_deg, gamma_deg</source>
        <translation>列：x_mm, y_mm, z_mm, alpha_deg, beta_deg, gamma_deg</translation>
    </message>
    <message>
        <source>Run report</source>
        <translation>运行报告</translation>
    </message>
    <message>
        <source>Move to each pose in turn and measure it; the platform moves</source>
        <translation>依次运动到每个位姿并测量；平台会运动</translation>
    </message>
    <message>
        <source>Clear samples</source>
        <translation>清空样本</translation>
    </message>
    <message>
        <source>Discard all samples</source>
        <translation>丢弃全部样本</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>样本</translation>
    </message>
    <message>
        <source>Preview of the report</source>
        <translation>报告预览</translation>
    </message>
    <message>
        <source>No samples yet</source>
        <translation>尚无样本</translation>
    </message>
    <message>
        <source>Report progress</source>
        <translation>报告进度</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Report folder</source>
        <translation>报告文件夹</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Choose the folder of the report</source>
        <translation>选择报告文件夹</translation>
    </message>
    <message>
        <source>Choose report folder</source>
        <translation>选择报告文件夹</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Report files</source>
        <translation>报告文件</translation>
    </message>
    <message>
        <source>the connection was closed</source>
        <translation>连接已关闭</translation>
    </message>
    <message>
        <source>Stop was pressed</source>
        <translation>已按“停止”</translation>
    </message>
</context>
<context>
    <name>hexapose::ReportWords</name>
    <message>
        <source>Angle error (rad)</source>
        <translation>角度误差（rad）</translation>
    </message>
    <message>
        <source>Displacement error (m)</source>
        <translation>位移误差（m）</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>样本</translation>
    </message>
    <message>
        <source>no solution</source>
        <translation>无可用解</translation>
    </message>
    <message>
        <source>largest predicted for %1 mm resolution</source>
        <translation>分辨率 %1 mm 的最大预测误差</translation>
    </message>
    <message>
        <source>No samples</source>
        <translation>没有样本</translation>
    </message>
    <message>
        <source>No sample has a usable solution</source>
        <translation>没有样本具有可用的解</translation>
    </message>
    <message>
        <source>converged</source>
        <translation>已收敛</translation>
    </message>
    <message>
        <source>iteration limit reached</source>
        <translation>达到迭代次数上限</translation>
    </message>
    <message>
        <source>singular</source>
        <translation>奇异</translation>
    </message>
    <message>
        <source>no pose of these lengths found</source>
        <translation>未找到符合这些腿长的位姿</translation>
    </message>
    <message>
        <source>invalid lengths</source>
        <translation>腿长无效</translation>
    </message>
    <message>
        <source>outside the model&apos;s range</source>
        <translation>超出模型范围</translation>
    </message>
    <message>
        <source>pose of another assembly mode</source>
        <translation>属于另一装配模式的位姿</translation>
    </message>
    <message>
        <source>Error in rad and m</source>
        <translation>误差，rad 与 m</translation>
    </message>
    <message>
        <source>Error in deg and mm</source>
        <translation>误差，deg 与 mm</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>均方根</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Predicted std. deviation</source>
        <translation>预测标准差</translation>
    </message>
    <message>
        <source>Predicted bound</source>
        <translation>预测上界</translation>
    </message>
    <message>
        <source>rad and m</source>
        <translation>rad 与 m</translation>
    </message>
    <message>
        <source>deg and mm</source>
        <translation>deg 与 mm</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Solved</source>
        <translation>求解</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>Forward kinematics error report</source>
        <translation>运动学正解误差报告</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>平台</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>求解器</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>样本</translation>
    </message>
    <message>
        <source>%1, of which %2 without a usable solution and not in the statistics</source>
        <translation>%1 个，其中 %2 个没有可用的解，不计入统计</translation>
    </message>
    <message>
        <source>Length resolution</source>
        <translation>腿长分辨率</translation>
    </message>
    <message>
        <source>Error: solved pose minus target. Maximum: of the absolute value. Predicted: what lengths rounded to %1 explain by themselves, through the inverse of the Jacobian; the bound is the worst case, the largest of all samples.</source>
        <translation>误差：求解位姿减去目标位姿。最大：绝对值的最大值。预测：腿长按 %1 舍入本身经雅可比矩阵之逆所能解释的误差；上界为最坏情况，取所有样本中的最大值。</translation>
    </message>
    <message>
        <source>Sample %1</source>
        <translation>样本 %1</translation>
    </message>
    <message>
        <source>%1, iterations: %2, residual: %3 mm, measurements averaged: %4</source>
        <translation>%1，迭代：%2，残差：%3 mm，平均的测量次数：%4</translation>
    </message>
    <message>
        <source>Lengths (mm): %1</source>
        <translation>腿长（mm）：%1</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>第 %1 页，共 %2 页</translation>
    </message>
</context>
<context>
    <name>hexapose::SampleTable</name>
    <message>
        <source>No.</source>
        <translation>序号</translation>
    </message>
    <message>
        <source>Solution</source>
        <translation>求解</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>均方根</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>最大</translation>
    </message>
</context>
<context>
    <name>hexapose::SequenceEnd</name>
    <message>
        <source>another motion was commanded</source>
        <translation>已下达另一个运动指令</translation>
    </message>
</context>
<context>
    <name>hexapose::SettleLine</name>
    <message>
        <source>within %1 mm and %2° for %3 s</source>
        <translation>在 %1 mm 和 %2° 以内持续 %3 s</translation>
    </message>
    <message>
        <source>each leg within %1 mm for %2 s</source>
        <translation>各支腿在 %1 mm 以内持续 %2 s</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>运动中</translation>
    </message>
    <message>
        <source>Not settled yet: %1</source>
        <translation>尚未稳定：%1</translation>
    </message>
    <message>
        <source>Settled: %1</source>
        <translation>已稳定：%1</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>稳定状态</translation>
    </message>
</context>
<context>
    <name>hexapose::SpeedControl</name>
    <message>
        <source>held</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Speed override: per cent of full speed for every motion; may be changed during a move</source>
        <translation>速度倍率：所有运动相对全速的百分比，运动中也可更改</translation>
    </message>
    <message>
        <source>Speed in force</source>
        <translation>当前速度</translation>
    </message>
</context>
<context>
    <name>hexapose::StatusPanel</name>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>数据延迟</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>求解器</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>迭代</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>Dropped frames</source>
        <translation>丢弃帧</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>平台</translation>
    </message>
</context>
<context>
    <name>hexapose::StatusText</name>
    <message>
        <source>Disconnected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>Not referenced</source>
        <translation>未回参考点</translation>
    </message>
    <message>
        <source>Disabled</source>
        <translation>未使能</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>已使能</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>运动中</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>稳定中</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Converged</source>
        <translation>已收敛</translation>
    </message>
    <message>
        <source>Iteration limit reached</source>
        <translation>达到迭代上限</translation>
    </message>
    <message>
        <source>Singular</source>
        <translation>奇异</translation>
    </message>
    <message>
        <source>No pose of these lengths was found</source>
        <translation>未找到符合这些腿长的位姿</translation>
    </message>
    <message>
        <source>Invalid lengths</source>
        <translation>腿长无效</translation>
    </message>
    <message>
        <source>Outside the model&apos;s range</source>
        <translation>超出模型范围</translation>
    </message>
    <message>
        <source>Pose of another assembly mode</source>
        <translation>属于另一装配构型的位姿</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>无数据</translation>
    </message>
    <message>
        <source>Not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Cannot run: this sender takes no commands</source>
        <translation>无法运行：该发送端不接受命令</translation>
    </message>
    <message>
        <source>Cannot run: no valid measurement received</source>
        <translation>无法运行：没有收到有效的测量值</translation>
    </message>
    <message>
        <source>Cannot run: press Clear first</source>
        <translation>无法运行：请先按“故障复位”</translation>
    </message>
    <message>
        <source>Cannot run while the platform moves</source>
        <translation>无法运行：平台正在运动</translation>
    </message>
    <message>
        <source>Cannot run: the controller does not answer yet</source>
        <translation>无法运行：控制器尚未应答</translation>
    </message>
    <message>
        <source>Cannot run: a motion is being prepared</source>
        <translation>无法运行：正在准备运动</translation>
    </message>
</context>
<context>
    <name>hexapose::TargetPanel</name>
    <message>
        <source>Target x</source>
        <translation>目标 x</translation>
    </message>
    <message>
        <source>Target y</source>
        <translation>目标 y</translation>
    </message>
    <message>
        <source>Target z</source>
        <translation>目标 z</translation>
    </message>
    <message>
        <source>Target alpha</source>
        <translation>目标 alpha</translation>
    </message>
    <message>
        <source>Target beta</source>
        <translation>目标 beta</translation>
    </message>
    <message>
        <source>Target gamma</source>
        <translation>目标 gamma</translation>
    </message>
    <message>
        <source>Rotation in degrees</source>
        <translation>转角，单位：度</translation>
    </message>
    <message>
        <source>Displacement in mm</source>
        <translation>位移，单位：mm</translation>
    </message>
    <message>
        <source>How far this axis alone can go from the present pose</source>
        <translation>其他轴不动时，该轴从当前位姿可到达的范围</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>极限</translation>
    </message>
    <message>
        <source>Validity</source>
        <translation>可达性</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Cannot run: nothing is connected</source>
        <translation>无法运行：尚未连接</translation>
    </message>
    <message>
        <source>Move to the target; references and enables first when that is needed</source>
        <translation>运动到目标；必要时先回参考点并使能</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>填入零位</translation>
    </message>
    <message>
        <source>Put the home pose into the fields; nothing moves</source>
        <translation>将零位填入各栏；不会产生运动</translation>
    </message>
    <message>
        <source>Copy measured</source>
        <translation>取实测值</translation>
    </message>
    <message>
        <source>Put the measured pose into the fields; nothing moves</source>
        <translation>将实测位姿填入各栏；不会产生运动</translation>
    </message>
    <message>
        <source>Reachable, but nothing is connected</source>
        <translation>可到达，但尚未连接</translation>
    </message>
    <message>
        <source>Target %1: %2</source>
        <translation>目标 %1：%2</translation>
    </message>
    <message>
        <source>Cannot run: no valid measurement received</source>
        <translation>无法运行：没有收到有效的测量值</translation>
    </message>
    <message>
        <source>Checking the target</source>
        <translation>正在检查目标</translation>
    </message>
</context>
<context>
    <name>hexapose::ViewBar</name>
    <message>
        <source>Open log</source>
        <translation>打开日志</translation>
    </message>
    <message>
        <source>Open one or several logs or CSV files</source>
        <translation>打开一个或多个日志或 CSV 文件</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后退</translation>
    </message>
    <message>
        <source>The view before (Backspace)</source>
        <translation>上一个视图（Backspace）</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>前进</translation>
    </message>
    <message>
        <source>The view after (Alt+Right)</source>
        <translation>下一个视图（Alt+右）</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>缩小</translation>
    </message>
    <message>
        <source>Show twice the time (-)</source>
        <translation>显示两倍的时间（-）</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>放大</translation>
    </message>
    <message>
        <source>Show half the time (+)</source>
        <translation>显示一半的时间（+）</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>显示全部</translation>
    </message>
    <message>
        <source>The whole log (Home)</source>
        <translation>整个日志（Home）</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>The charts as PNG, SVG or PDF, or the rows shown as CSV</source>
        <translation>将图表导出为 PNG、SVG 或 PDF，或将所示的行导出为 CSV</translation>
    </message>
    <message>
        <source>Cursor A</source>
        <translation>光标 A</translation>
    </message>
    <message>
        <source>Cursor B</source>
        <translation>光标 B</translation>
    </message>
    <message>
        <source>Time in s; a click into a chart sets A, with Ctrl B; the keys A and B too</source>
        <translation>时间，s；在图表中单击设置 A，按住 Ctrl 单击设置 B；也可用 A 键和 B 键</translation>
    </message>
</context>
<context>
    <name>hexapose::ViewerMenu</name>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>With the focus on a chart:
left and right: move through time
+ and -: zoom
Home: everything
Backspace or Alt+left, Alt+right: views back and forward
A and B: set a cursor at the pointer, or in the middle
Ctrl+left and Ctrl+right: the cursor set last, row by row
Esc: no cursors
Menu: curves and charts

Mouse: the wheel zooms in time, with Ctrl in values, with Shift it moves; a box zooms; Shift and drag moves; a click sets cursor A, with Ctrl cursor B.</source>
        <translation>焦点在图表上时：
左右键：在时间上移动
+ 和 -：缩放
Home：全部
Backspace 或 Alt+左、Alt+右：后退和前进
A 和 B：在指针处或视图中间设置光标
Ctrl+左、Ctrl+右：逐行移动上次设置的光标
Esc：取消光标
菜单键：曲线和图表

鼠标：滚轮缩放时间，按住 Ctrl 缩放数值，按住 Shift 平移；拖框放大；按住 Shift 拖动平移；单击设置光标 A，按住 Ctrl 单击设置光标 B。</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Open log...</source>
        <translation>打开日志(&amp;O)...</translation>
    </message>
    <message>
        <source>Open another log in this &amp;layout...</source>
        <translation>用此布局打开另一日志(&amp;L)...</translation>
    </message>
    <message>
        <source>&amp;Recent logs</source>
        <translation>最近的日志(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>导出(&amp;E)...</translation>
    </message>
    <message>
        <source>&amp;Close log</source>
        <translation>关闭日志(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Charts</source>
        <translation>图表(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Add chart</source>
        <translation>添加图表(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Save layout...</source>
        <translation>保存布局(&amp;S)...</translation>
    </message>
    <message>
        <source>&amp;Load layout...</source>
        <translation>载入布局(&amp;L)...</translation>
    </message>
    <message>
        <source>&amp;Usual charts</source>
        <translation>默认图表(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Keys...</source>
        <translation>按键(&amp;K)...</translation>
    </message>
</context>
<context>
    <name>hexapose::ViewerWindow</name>
    <message>
        <source>Open log</source>
        <translation>打开日志</translation>
    </message>
    <message>
        <source>Logs and tables (*.csv *.csv.gz *.tsv *.txt);;All files (*)</source>
        <translation>日志和表格 (*.csv *.csv.gz *.tsv *.txt);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>PNG picture (*.png);;SVG drawing (*.svg);;PDF page (*.pdf);;Rows shown, as they stand in the log (*.csv)</source>
        <translation>PNG 图片 (*.png);;SVG 图形 (*.svg);;PDF 页面 (*.pdf);;所示的行，与日志原文相同 (*.csv)</translation>
    </message>
    <message>
        <source>Save layout</source>
        <translation>保存布局</translation>
    </message>
    <message>
        <source>Layouts (*.json)</source>
        <translation>布局 (*.json)</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 无法写入：%2</translation>
    </message>
    <message>
        <source>Load layout</source>
        <translation>载入布局</translation>
    </message>
    <message>
        <source>Layouts (*.json);;All files (*)</source>
        <translation>布局 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Hexapose viewer</source>
        <translation>Hexapose 日志查看器</translation>
    </message>
    <message>
        <source>Open logs</source>
        <translation>已打开的日志</translation>
    </message>
    <message>
        <source>Open a log (Ctrl+O), or drop a file here</source>
        <translation>打开日志（Ctrl+O），或将文件拖放到这里</translation>
    </message>
    <message>
        <source>Open log in this layout</source>
        <translation>用此布局打开日志</translation>
    </message>
</context>
<context>
    <name>hexapose::WayPointsPanel</name>
    <message>
        <source>Save the way-points</source>
        <translation>保存路径点</translation>
    </message>
    <message>
        <source>Load way-points</source>
        <translation>载入路径点</translation>
    </message>
    <message>
        <source>Poses (*.csv);;All files (*)</source>
        <translation>位姿 (*.csv);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Way-points</source>
        <translation>路径点</translation>
    </message>
    <message>
        <source>x y z in mm, alpha beta gamma in degrees; a double click edits</source>
        <translation>x y z 单位 mm，alpha beta gamma 单位度；双击可编辑</translation>
    </message>
    <message>
        <source>+ Measured</source>
        <translation>+ 实测</translation>
    </message>
    <message>
        <source>Add measured</source>
        <translation>添加实测</translation>
    </message>
    <message>
        <source>Add the measured pose; nothing moves</source>
        <translation>添加实测位姿；不会产生运动</translation>
    </message>
    <message>
        <source>+ Target</source>
        <translation>+ 目标</translation>
    </message>
    <message>
        <source>Add target</source>
        <translation>添加目标</translation>
    </message>
    <message>
        <source>Add the pose of the target&apos;s fields; nothing moves</source>
        <translation>添加目标栏中的位姿；不会产生运动</translation>
    </message>
    <message>
        <source>Load...</source>
        <translation>载入...</translation>
    </message>
    <message>
        <source>From CSV: columns x_mm, y_mm, z_mm, alpha_deg, beta_deg, gamma_deg</source>
        <translation>来自 CSV：列 x_mm、y_mm、z_mm、alpha_deg、beta_deg、gamma_deg</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>保存...</translation>
    </message>
    <message>
        <source>Save way-points</source>
        <translation>保存路径点</translation>
    </message>
    <message>
        <source>As CSV with the same columns</source>
        <translation>存为 CSV，列相同</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>执行</translation>
    </message>
    <message>
        <source>Visit them all, from the first; the platform moves</source>
        <translation>从第一个起依次到达全部路径点；平台会运动</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Pause motion</source>
        <translation>暂停运动</translation>
    </message>
    <message>
        <source>Hold the motion on its path; press again to go on</source>
        <translation>在路径上保持；再按一次继续</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>单步</translation>
    </message>
    <message>
        <source>Go to the next one only; the platform moves</source>
        <translation>只到下一个路径点；平台会运动</translation>
    </message>
    <message>
        <source>Remove way-point</source>
        <translation>删除路径点</translation>
    </message>
    <message>
        <source>Remove the chosen row</source>
        <translation>删除所选行</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>上移</translation>
    </message>
    <message>
        <source>Move the chosen row up</source>
        <translation>上移所选行</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>下移</translation>
    </message>
    <message>
        <source>Move the chosen row down</source>
        <translation>下移所选行</translation>
    </message>
    <message>
        <source>Way-point progress</source>
        <translation>路径点进度</translation>
    </message>
    <message>
        <source>Add poses, or load them; nothing moves until Play or Step</source>
        <translation>请添加或载入位姿；按“执行”或“单步”前不会产生运动</translation>
    </message>
    <message>
        <source>Ended at way-point %1: the connection was closed</source>
        <translation>在路径点 %1 处结束：连接已关闭</translation>
    </message>
    <message>
        <source>Row %1: %2. Nothing moved.</source>
        <translation>第 %1 行：%2。未产生运动。</translation>
    </message>
    <message>
        <source>To way-point %1 of %2</source>
        <translation>前往路径点 %1 / %2</translation>
    </message>
    <message>
        <source>Ended at way-point %1: %2</source>
        <translation>在路径点 %1 处结束：%2</translation>
    </message>
    <message>
        <source>All %1 way-points visited</source>
        <translation>已到达全部 %1 个路径点</translation>
    </message>
    <message>
        <source>At way-point %1</source>
        <translation>已到达路径点 %1</translation>
    </message>
    <message>
        <source>Stopped while moving to way-point %1. Press Clear, then Play or Step.</source>
        <translation>在前往路径点 %1 途中停止。请按“故障复位”，再按“执行”或“单步”。</translation>
    </message>
    <message>
        <source>%1 way-points from %2</source>
        <translation>%2 中的 %1 个路径点</translation>
    </message>
    <message>
        <source>The list cannot be used: %1</source>
        <translation>无法使用该列表：%1</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>已保存为 %1</translation>
    </message>
    <message>
        <source>The list cannot be saved: %1</source>
        <translation>无法保存列表：%1</translation>
    </message>
    <message>
        <source>Row %1: %2: %3</source>
        <translation>第 %1 行：%2：%3</translation>
    </message>
    <message>
        <source>A field of the target is refused</source>
        <translation>目标中有一项未被接受</translation>
    </message>
    <message>
        <source>Checking the list; Stop ends it</source>
        <translation>正在检查列表；按“停止”可结束</translation>
    </message>
    <message>
        <source>The platform is not ready any more. Nothing moved.</source>
        <translation>平台已不再就绪。未产生运动。</translation>
    </message>
</context>
<context>
    <name>hexapose::WindowMenu</name>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Esc: Stop, wherever the focus is.

Jog, with the focus on its buttons, for as long as the key is held:
left and right: x
down and up: y
page down and page up: z
with Shift: alpha, beta, gamma
space: the button with the focus

A second key, another window or a menu ends the motion.</source>
        <translation>Esc：停止，无论焦点在何处。

点动：焦点在点动按钮上时，按住按键期间运动：
左、右：x
下、上：y
PgDn、PgUp：z
加 Shift：alpha、beta、gamma
空格：焦点所在的按钮

按下第二个键、切换窗口或打开菜单都会结束运动。</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Keys...</source>
        <translation>按键(&amp;K)...</translation>
    </message>
</context>
</TS>
