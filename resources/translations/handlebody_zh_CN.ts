<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Findings</name>
    <message>
        <source>the surface is held at a neck of radius {radius_mm:3g} mm: behind it the same intensities go on for at least {behind_ml:3g} ml, in front of it they fill {in_front_ml:3g} ml; where that belongs to the object, put a seed there too, or set the range in step 3, Tune, which holds nothing back</source>
        <translation>表面被挡在半径 {radius_mm:3g} mm 的狭窄处：其后相同强度至少延续 {behind_ml:3g} ml，其前填充 {in_front_ml:3g} ml；如果那里属于目标，请在那里也放一个种子点，或在第 3 步“调整”中设置范围（不会阻挡任何部分）</translation>
    </message>
    <message>
        <source>the surface is held at a hole of radius {radius_mm:3g} mm in a thin wall: behind it the same intensities go on for at least {behind_ml:3g} ml, in front of it they fill {in_front_ml:3g} ml; where that belongs to the object, put a seed there too, or set the range in step 3, Tune, which holds nothing back</source>
        <translation>表面被挡在薄壁上半径 {radius_mm:3g} mm 的孔处：其后相同强度至少延续 {behind_ml:3g} ml，其前填充 {in_front_ml:3g} ml；如果那里属于目标，请在那里也放一个种子点，或在第 3 步“调整”中设置范围（不会阻挡任何部分）</translation>
    </message>
    <message>
        <source>the surface is held where its structure grows wider than a radius of {radius_mm:3g} mm: behind it the same intensities go on for at least {behind_ml:3g} ml, in front of it they fill {in_front_ml:3g} ml; where that belongs to the object, put a seed there too, or set the range in step 3, Tune, which holds nothing back</source>
        <translation>表面被挡在结构半径超过 {radius_mm:3g} mm 的变宽处：其后相同强度至少延续 {behind_ml:3g} ml，其前填充 {in_front_ml:3g} ml；如果那里属于目标，请在那里也放一个种子点，或在第 3 步“调整”中设置范围（不会阻挡任何部分）</translation>
    </message>
    <message>
        <source>the surface got stuck: no part of a step could be kept, again and again; another edge length may help</source>
        <translation>表面已卡住：多次无法保留一步中的任何部分；更换边长可能有帮助</translation>
    </message>
    <message>
        <source>the surface rests at places that would still move, because changes there failed or repeated again and again; another edge length or smoothing may help</source>
        <translation>表面停在仍会移动的位置，因为那里的变化反复失败或重复；更换边长或平滑可能有帮助</translation>
    </message>
    <message>
        <source>the surface hardly grew beyond its seed: look at the kind of object and the range in step 3, Tune</source>
        <translation>表面几乎没有超出种子点：请检查第 3 步“调整”中的目标类型和范围</translation>
    </message>
    <message>
        <source>the surface hardly grew beyond its seed: the curvature weight holds every front of a radius below {radius_mm:3g} mm, and the seed is smaller; give it a larger radius, or lower the weight</source>
        <translation>表面几乎没有超出种子点：曲率权重阻止半径小于 {radius_mm:3g} mm 的前沿，而种子点更小；请加大其半径或降低权重</translation>
    </message>
    <message>
        <source>the choice among {objects} objects is close (expected overlap with the one that is meant: Dice {dice:2g}): the next candidate holds {next_ml:3m} ml where this one holds {this_ml:3m} ml; another one can be chosen in step 2, Seed</source>
        <translation>{objects} 个目标之间难以取舍（与所指目标的预期重叠：Dice {dice:2g}）：下一个候选为 {next_ml:3m} ml，当前为 {this_ml:3m} ml；可在第 2 步“种子点”中另选</translation>
    </message>
    <message>
        <source>the surface leaked at iteration {iteration}: {cause}</source>
        <translation>表面在第 {iteration} 次迭代时泄漏：{cause}</translation>
    </message>
    <message>
        <source>the surface leaked at iteration {iteration}: {cause}; a wall was put there</source>
        <translation>表面在第 {iteration} 次迭代时泄漏：{cause}；已在那里设置屏障</translation>
    </message>
    <message>
        <source>the surface leaked at iteration {iteration}: {cause}; the mesh is that of iteration {mesh_iteration}, before it came there</source>
        <translation>表面在第 {iteration} 次迭代时泄漏：{cause}；网格取自到达那里之前的第 {mesh_iteration} 次迭代</translation>
    </message>
    <message>
        <source>The seed is not in an object with a boundary of its own: what grows from it fills the field of view, up to the padding around the image. Where that is meant, say whether it is dark or bright, or set the range in step 3, Tune.</source>
        <translation>种子点不在有自身边界的目标内：由它生长的部分会填满视野直至图像周围的填充区。如果确实如此，请指定暗或亮，或在第 3 步“调整”中设置范围。</translation>
    </message>
    <message>
        <source>The seed at {place:1f} mm lies outside the volume.</source>
        <translation>位于 {place:1f} mm 的种子点在体数据之外。</translation>
    </message>
    <message>
        <source>The click outside of the object at {place:1f} mm lies outside the volume.</source>
        <translation>位于 {place:1f} mm 的外部点在体数据之外。</translation>
    </message>
    <message>
        <source>The seed at {place:1f} mm is not in the object: the smoothed intensity there is {intensity:4g}, the object's range is {low:4g} to {high:4g}.</source>
        <translation>位于 {place:1f} mm 的种子点不在目标内：该处平滑后的强度为 {intensity:4g}，目标范围为 {low:4g} 至 {high:4g}。</translation>
    </message>
    <message>
        <source>The range {low:4g} to {high:4g} holds no voxel of the volume, whose values run from {least:4g} to {most:4g}.</source>
        <translation>范围 {low:4g} 至 {high:4g} 内没有体素，体数据的取值为 {least:4g} 至 {most:4g}。</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
    <message>
        <source>{percent:0f} % of the surface lies where the image shows no edge: the object may go on there, or the surface leaked</source>
        <translation>{percent:0f} % 的表面位于图像没有边缘的地方：目标可能在那里延续，或表面已泄漏</translation>
    </message>
    <message>
        <source>{percent:0f} % of the surface lies on the border of the volume: the object is cut off there, or the surface leaked</source>
        <translation>{percent:0f} % 的表面位于体数据边界：目标在那里被截断，或表面已泄漏</translation>
    </message>
    <message>
        <source>{percent:0f} % of the surface lies on the border of the field of view: the object is cut off there, or the surface leaked</source>
        <translation>{percent:0f} % 的表面位于视野边界：目标在那里被截断，或表面已泄漏</translation>
    </message>
    <message>
        <source>the surface still lies in a wall that was put over it</source>
        <translation>表面仍位于盖在其上的屏障内</translation>
    </message>
    <message>
        <source>at the allowed place {place} nothing came that a limit of the topology would have held</source>
        <translation>在允许的位置 {place} 没有出现会被拓扑限制阻挡的变化</translation>
    </message>
    <message>
        <source>the surface is held at passages narrower than a radius of {radius_mm:3g} mm; where what lies behind them belongs to the object, put a seed there too, or take a larger candidate</source>
        <translation>表面被挡在半径小于 {radius_mm:3g} mm 的通道处；如果其后部分属于目标，请在那里也放一个种子点或选取更大的候选</translation>
    </message>
    <message>
        <source>the object reaches the end of what was searched around the seed and is cut off there; where it goes on, put a seed there too</source>
        <translation>目标到达种子点周围搜索范围的边缘，在那里被截断；如果它在其后继续，请在那里也放一个种子点</translation>
    </message>
    <message>
        <source>it came through a passage {width_mm:1f} mm wide at {place:1f} from a space {before_mm:0f} mm wide into one {behind_mm:0f} mm wide</source>
        <translation>它在 {place:1f} 处穿过宽 {width_mm:1f} mm 的通道，从宽 {before_mm:0f} mm 的空间进入宽 {behind_mm:0f} mm 的空间</translation>
    </message>
    <message>
        <source>it came through a passage too narrow for the voxels to show at {place:1f} from a space {before_mm:0f} mm wide into one {behind_mm:0f} mm wide</source>
        <translation>它在 {place:1f} 处穿过体素无法显示的狭窄通道，从宽 {before_mm:0f} mm 的空间进入宽 {behind_mm:0f} mm 的空间</translation>
    </message>
    <message>
        <source>the pin {pin} holds nothing: the mesh is that of iteration {mesh_iteration}, and its iteration never came</source>
        <translation>固定 {pin} 未起作用：网格取自第 {mesh_iteration} 次迭代，从未到达其迭代</translation>
    </message>
    <message>
        <source>With clicks, smoothing and noise a little different, {runs} of {of} runs leave no surface</source>
        <translation>略微改变点击位置、平滑和噪声后，{of} 次运行中有 {runs} 次没有留下表面</translation>
    </message>
    <message>
        <source>With clicks, smoothing and noise a little different, {runs} of {of} runs have another topology</source>
        <translation>略微改变点击位置、平滑和噪声后，{of} 次运行中有 {runs} 次拓扑不同</translation>
    </message>
    <message>
        <source>The volume depends on where exactly is clicked, on smoothing or noise: it changes by {percent:0f} %</source>
        <translation>体积取决于确切的点击位置、平滑或噪声：变化 {percent:0f} %</translation>
    </message>
    <message>
        <source>The surface was made with an earlier one of the object '{object}', and a replay may make another</source>
        <translation>该表面是用目标“{object}”的较早表面生成的，重放可能得到不同结果</translation>
    </message>
    <message>
        <source>kept apart here, as asked</source>
        <translation>按要求在此保持分离</translation>
    </message>
    <message>
        <source>held: it would break the limit of the topology</source>
        <translation>已阻止：会超出拓扑限制</translation>
    </message>
    <message>
        <source>the same place changed again and again, and rests from now on</source>
        <translation>同一位置反复变化，从现在起静止</translation>
    </message>
    <message>
        <source>no part of the step could be kept</source>
        <translation>这一步的任何部分都无法保留</translation>
    </message>
    <message>
        <source>{fronts} fronts could not be joined at once: {cause}</source>
        <translation>{fronts} 个前沿无法同时连接：{cause}</translation>
    </message>
    <message>
        <source>of {fronts} fronts {left} left for the next round</source>
        <translation>{fronts} 个前沿中有 {left} 个留待下一轮</translation>
    </message>
    <message>
        <source>1 ring added: {cause}</source>
        <translation>增加 1 环：{cause}</translation>
    </message>
    <message>
        <source>{rings} rings added: {cause}</source>
        <translation>增加 {rings} 环：{cause}</translation>
    </message>
    <message>
        <source>there may be a shorter handle</source>
        <translation>可能存在更短的环柄</translation>
    </message>
    <message>
        <source>the surface came to a pinned part, and stops before it</source>
        <translation>表面到达固定部分并停在其前</translation>
    </message>
    <message>
        <source>to close the place would take too much work</source>
        <translation>闭合该处的计算量过大</translation>
    </message>
    <message>
        <source>the work that a step may take is done: the place waits</source>
        <translation>一步允许的工作量已用完：该处等待</translation>
    </message>
    <message>
        <source>the fronts meet through the inside of the object</source>
        <translation>前沿穿过目标内部相遇</translation>
    </message>
    <message>
        <source>no handle fits</source>
        <translation>没有合适的环柄</translation>
    </message>
    <message>
        <source>no patch fits</source>
        <translation>没有合适的补片</translation>
    </message>
    <message>
        <source>the component encloses a place where no surface may go</source>
        <translation>该连通分量包围了表面不得进入的位置</translation>
    </message>
    <message>
        <source>the opening is too large</source>
        <translation>开口过大</translation>
    </message>
    <message>
        <source>a pinned part lies there</source>
        <translation>那里有固定部分</translation>
    </message>
    <message>
        <source>nothing of the component would be left</source>
        <translation>该连通分量将不复存在</translation>
    </message>
    <message>
        <source>the surface would have entered a wall</source>
        <translation>表面会进入屏障</translation>
    </message>
    <message>
        <source>a part of the surface has changed that detection had not looked at</source>
        <translation>表面有一部分发生变化而未经检测</translation>
    </message>
    <message>
        <source>the events of the step do not follow from each other</source>
        <translation>这一步的事件前后不一致</translation>
    </message>
    <message>
        <source>the Euler number is not the one that the events predict</source>
        <translation>欧拉数与事件预测不符</translation>
    </message>
    <message>
        <source>the components are not those that the events predict</source>
        <translation>连通分量与事件预测不符</translation>
    </message>
    <message>
        <source>a cavity lies outside of any body</source>
        <translation>有空腔位于所有实体之外</translation>
    </message>
    <message>
        <source>a body lies directly in another</source>
        <translation>一个实体直接位于另一个之内</translation>
    </message>
    <message>
        <source>the surface still intersected itself after several changes</source>
        <translation>多次更改后表面仍自相交</translation>
    </message>
    <message>
        <source>the surface does not enclose a volume</source>
        <translation>表面未围成体积</translation>
    </message>
    <message>
        <source>the surface would close over a pinned part, and stops before it</source>
        <translation>表面会在固定部分上闭合，已停在其前</translation>
    </message>
    <message>
        <source>a pinned part would have changed</source>
        <translation>固定部分本会改变</translation>
    </message>
    <message>
        <source>the surface would come into a wall or around it</source>
        <translation>表面会进入或包围屏障</translation>
    </message>
    <message>
        <source>a pinned part would change</source>
        <translation>固定部分会改变</translation>
    </message>
    <message>
        <source>there would be more components than may be</source>
        <translation>连通分量数会超过允许值</translation>
    </message>
    <message>
        <source>there would be more tunnels than may be</source>
        <translation>隧道数会超过允许值</translation>
    </message>
    <message>
        <source>an edge has only one face</source>
        <translation>有一条边只属于一个面</translation>
    </message>
    <message>
        <source>two faces disagree about their common edge</source>
        <translation>两个面的公共边不一致</translation>
    </message>
    <message>
        <source>the two faces of an edge run in the same direction or have other ends</source>
        <translation>一条边的两个面方向相同或端点不同</translation>
    </message>
    <message>
        <source>two faces have the same three vertices</source>
        <translation>两个面的三个顶点相同</translation>
    </message>
    <message>
        <source>a face has a vertex that was removed</source>
        <translation>有面使用了已删除的顶点</translation>
    </message>
    <message>
        <source>a face has a vertex twice</source>
        <translation>有面重复使用同一顶点</translation>
    </message>
    <message>
        <source>a vertex has no face</source>
        <translation>有顶点不属于任何面</translation>
    </message>
    <message>
        <source>a vertex names a half-edge that does not leave it</source>
        <translation>有顶点指向并非从它出发的半边</translation>
    </message>
    <message>
        <source>two edges join the same two vertices</source>
        <translation>两条边连接相同的两个顶点</translation>
    </message>
    <message>
        <source>the faces around a vertex form more than one fan</source>
        <translation>一个顶点周围的面构成多个扇形</translation>
    </message>
    <message>
        <source>the counts of the mesh are not those of its elements</source>
        <translation>网格计数与其元素不符</translation>
    </message>
    <message>
        <source>no vertex of the surface lies in the ball</source>
        <translation>球内没有表面顶点</translation>
    </message>
    <message>
        <source>the plane does not meet the surface</source>
        <translation>平面不与表面相交</translation>
    </message>
    <message>
        <source>the plane does not meet the surface near that place</source>
        <translation>平面在该处附近不与表面相交</translation>
    </message>
    <message>
        <source>no flat cap fits the cut</source>
        <translation>没有适合切口的平盖</translation>
    </message>
    <message>
        <source>the cut does not part the body there: both of its sides hang together</source>
        <translation>切割未分开该处实体：两侧仍相连</translation>
    </message>
    <message>
        <source>the pull goes too far for its radius</source>
        <translation>拉动距离相对其半径过大</translation>
    </message>
    <message>
        <source>nothing of the surface would be left</source>
        <translation>表面将不复存在</translation>
    </message>
    <message>
        <source>the surface would meet itself there</source>
        <translation>表面会在那里与自身相遇</translation>
    </message>
    <message>
        <source>No seed was given: at least one is needed.</source>
        <translation>没有种子点：至少需要一个。</translation>
    </message>
    <message>
        <source>The radius of a seed must be a number of mm above 0.</source>
        <translation>种子点半径必须大于 0 mm。</translation>
    </message>
    <message>
        <source>The seed is not in a dark object: the image has no clear boundary of that kind around it.</source>
        <translation>种子点不在暗目标内：图像在其周围没有此类清晰边界。</translation>
    </message>
    <message>
        <source>The seed is not in a bright object: the image has no clear boundary of that kind around it.</source>
        <translation>种子点不在亮目标内：图像在其周围没有此类清晰边界。</translation>
    </message>
    <message>
        <source>The seed is not in a dark or bright object: the image has no clear boundary of that kind around it.</source>
        <translation>种子点不在暗或亮目标内：图像在其周围没有此类清晰边界。</translation>
    </message>
    <message>
        <source>The range is empty: its lower end is above its upper end.</source>
        <translation>范围为空：下限高于上限。</translation>
    </message>
    <message>
        <source>Clicks outside of the object and a given range do not go together: the range alone says where the object ends.</source>
        <translation>外部点与给定范围不能并用：目标边界仅由范围决定。</translation>
    </message>
    <message>
        <source>The edge length of {edge_mm} mm is too short for the seeds: their surface alone would have over two million triangles.</source>
        <translation>边长 {edge_mm} mm 对种子点过短：仅其表面就会有超过两百万个三角形。</translation>
    </message>
    <message>
        <source>The seed at {place} mm lies in the object '{object}', which is done already.</source>
        <translation>位于 {place} mm 的种子点在已完成的目标“{object}”内。</translation>
    </message>
    <message>
        <source>A wall lies over the seed at {place} mm.</source>
        <translation>位于 {place} mm 的种子点被屏障覆盖。</translation>
    </message>
    <message>
        <source>A wall leaves the seed at {place} mm no room.</source>
        <translation>屏障使位于 {place} mm 的种子点没有空间。</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies within the surface, which cannot be pushed out of it: go back to before it came in there.</source>
        <translation>位于 {place} mm 的屏障在表面内部，无法将表面推出：请退回到表面到达那里之前。</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies across surface that is already there: go back to before it came in there.</source>
        <translation>位于 {place} mm 的屏障横穿已有表面：请退回到表面到达那里之前。</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies over surface that is already there: go back to before it came in there, or let the surface move in both directions.</source>
        <translation>位于 {place} mm 的屏障盖在已有表面上：请退回到表面到达那里之前，或允许表面双向移动。</translation>
    </message>
    <message>
        <source>The object '{object}' lies over surface that is already there: go back to before it came in there.</source>
        <translation>目标“{object}”盖在已有表面上：请退回到表面到达那里之前。</translation>
    </message>
    <message>
        <source>The clicks have so little in common with the surface that it would begin anew, but a part of it is pinned: take the pins away first.</source>
        <translation>点击与表面几乎没有共同之处，表面会重新开始，但其中一部分已固定：请先取消固定。</translation>
    </message>
    <message>
        <source>The veto of iteration {iteration} comes too late: the surface is at iteration {now}.</source>
        <translation>第 {iteration} 次迭代的否决来得太晚：表面已在第 {now} 次迭代。</translation>
    </message>
    <message>
        <source>The veto of iteration {iteration} has nothing to forbid: no change of topology happens there.</source>
        <translation>第 {iteration} 次迭代的否决无可禁止：那里没有拓扑变化。</translation>
    </message>
    <message>
        <source>The pin {pin} comes too late: the surface is at iteration {now}.</source>
        <translation>固定 {pin} 来得太晚：表面已在第 {now} 次迭代。</translation>
    </message>
    <message>
        <source>The pin {pin} holds nothing: no vertex of the surface lies there at iteration {now}.</source>
        <translation>固定 {pin} 未起作用：第 {now} 次迭代时那里没有表面顶点。</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} comes too late: the surface is at iteration {now}.</source>
        <translation>第 {iteration} 次迭代的编辑来得太晚：表面已在第 {now} 次迭代。</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} cannot be made: {cause}.</source>
        <translation>第 {iteration} 次迭代的编辑无法进行：{cause}。</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} finds no tunnel at {place}.</source>
        <translation>第 {iteration} 次迭代的编辑在 {place} 处未找到隧道。</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} finds no component at {place}.</source>
        <translation>第 {iteration} 次迭代的编辑在 {place} 处未找到连通分量。</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} finds no cavity at {place}.</source>
        <translation>第 {iteration} 次迭代的编辑在 {place} 处未找到空腔。</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} cannot be made: no cap fits into the tunnel at {place}.</source>
        <translation>第 {iteration} 次迭代的编辑无法进行：没有适合 {place} 处隧道的盖。</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} finds nothing to remove: there is nothing beside that component.</source>
        <translation>第 {iteration} 次迭代的编辑没有可移除的部分：除该连通分量外别无其他。</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} would leave nothing of the surface.</source>
        <translation>第 {iteration} 次迭代的编辑会使表面完全消失。</translation>
    </message>
    <message>
        <source>The surface vanished after {iterations} iterations: the seeds are not in an object of that kind and range.</source>
        <translation>表面在 {iterations} 次迭代后消失：种子点不在该类型和范围的目标内。</translation>
    </message>
    <message>
        <source>at iteration {iteration} a limit of the topology holds: {cause}; step 4, Grow, asks whether it may happen</source>
        <translation>第 {iteration} 次迭代时拓扑限制起作用：{cause}；第 4 步“生长”询问是否允许发生</translation>
    </message>
    <message>
        <source>it would enclose a cavity of {ml:3g} ml at {place:1f}</source>
        <translation>它将在 {place:1f} 处围出 {ml:3g} ml 的空腔</translation>
    </message>
    <message>
        <source>a part of {ml:3g} ml would come off at {place:1f}</source>
        <translation>{ml:3g} ml 的部分将在 {place:1f} 处脱离</translation>
    </message>
    <message>
        <source>its fronts would meet at {place:1f}</source>
        <translation>其前沿将在 {place:1f} 处相遇</translation>
    </message>
    <message>
        <source>its fronts would meet at {place:1f} and make a tunnel {around_mm:3g} mm around</source>
        <translation>其前沿将在 {place:1f} 处相遇，形成周长 {around_mm:3g} mm 的隧道</translation>
    </message>
    <message>
        <source>a change of its topology ({event}) would happen at {place:1f}</source>
        <translation>将在 {place:1f} 处发生拓扑变化（{event}）</translation>
    </message>
    <message>
        <source>its voxels cannot be read: {cause}</source>
        <translation>无法读取其体素：{cause}</translation>
    </message>
    <message>
        <source>no object can be grown here: {cause}</source>
        <translation>此处无法生长目标：{cause}</translation>
    </message>
    <message>
        <source>the surface was still moving at the iteration limit</source>
        <translation>达到迭代上限时表面仍在移动</translation>
    </message>
    <message>
        <source>the surface got stuck before it was at rest</source>
        <translation>表面在静止之前卡住</translation>
    </message>
    <message>
        <source>the surface rests, but parts that could not be mended would still move</source>
        <translation>表面已静止，但无法修正的部分仍会移动</translation>
    </message>
    <message>
        <source>its voxels cannot be read</source>
        <translation>无法读取其体素</translation>
    </message>
    <message>
        <source>the surface vanished</source>
        <translation>表面已消失</translation>
    </message>
    <message>
        <source>the surface leaked: {cause}</source>
        <translation>表面泄漏：{cause}</translation>
    </message>
    <message>
        <source>the volume jumps from {from_ml:4g} ml in frame {from_frame} to {to_ml:4g} ml</source>
        <translation>体积从第 {from_frame} 帧的 {from_ml:4g} ml 跳变为 {to_ml:4g} ml</translation>
    </message>
    <message>
        <source>the topology changes from 1 component of genus {genus_before} to 1 component of genus {genus}</source>
        <translation>拓扑由亏格为 {genus_before} 的 1 个连通分量变为亏格为 {genus} 的 1 个连通分量</translation>
    </message>
    <message>
        <source>the topology changes from 1 component of genus {genus_before} to {components} components of genus {genus}</source>
        <translation>拓扑由亏格为 {genus_before} 的 1 个连通分量变为总亏格为 {genus} 的 {components} 个连通分量</translation>
    </message>
    <message>
        <source>the topology changes from {components_before} components of genus {genus_before} to 1 component of genus {genus}</source>
        <translation>拓扑由总亏格为 {genus_before} 的 {components_before} 个连通分量变为亏格为 {genus} 的 1 个连通分量</translation>
    </message>
    <message>
        <source>the topology changes from {components_before} components of genus {genus_before} to {components} components of genus {genus}</source>
        <translation>拓扑由总亏格为 {genus_before} 的 {components_before} 个连通分量变为总亏格为 {genus} 的 {components} 个连通分量</translation>
    </message>
    <message>
        <source>the topology was held at 1 place, the first at {place} mm</source>
        <translation>拓扑变化在 1 处被阻止，位于 {place} mm</translation>
    </message>
    <message>
        <source>the topology was held at {places} places, the first at {place} mm</source>
        <translation>拓扑变化在 {places} 处被阻止，首处位于 {place} mm</translation>
    </message>
    <message>
        <source>another object is likelier there, but it fails ({cause}); candidate {candidate} was taken</source>
        <translation>那里另一目标可能性更大，但失败（{cause}）；已采用候选 {candidate}</translation>
    </message>
    <message>
        <source>this is a cine (2D images over time: {frames:0f} frames), not a volume; if its frames are slices in space, enter their spacing in step 1, Open</source>
        <translation>这是电影序列（随时间变化的二维图像：{frames:0f} 帧），不是体数据；如果各帧是空间中的切面，请在第 1 步“打开”中输入其间距</translation>
    </message>
    <message>
        <source>{file}: {cause}.</source>
        <translation>{file}：{cause}。</translation>
    </message>
    <message>
        <source>{file}: {cause}</source>
        <translation>{file}：{cause}</translation>
    </message>
    <message>
        <source>{file}: {cause} in line {line:0f}.</source>
        <translation>{file}：{cause}，第 {line:0f} 行。</translation>
    </message>
    <message>
        <source>{file}: cannot be written: {cause}.</source>
        <translation>无法写入 {file}：{cause}。</translation>
    </message>
    <message>
        <source>{file}: it holds no series {series}.</source>
        <translation>{file}：其中没有序列 {series}。</translation>
    </message>
    <message>
        <source>{file} cannot be a surface to begin with: it {cause}.</source>
        <translation>{file} 不能作为起始表面：{cause}。</translation>
    </message>
    <message>
        <source>{file} is not the file that the session began with: its SHA-256 differs.</source>
        <translation>{file} 不是会话起始时所用的文件：其 SHA-256 不同。</translation>
    </message>
    <message>
        <source>{file} is not the volume that the session was made from: its SHA-256 differs.</source>
        <translation>{file} 不是生成该会话的体数据：其 SHA-256 不同。</translation>
    </message>
    <message>
        <source>{file} is not the label map that the walls were made from: its SHA-256 differs.</source>
        <translation>{file} 不是生成屏障的标签图：其 SHA-256 不同。</translation>
    </message>
    <message>
        <source>{file} cannot be used as walls: it has {size} voxels, the volume has {volume}.</source>
        <translation>{file} 不能用作屏障：它有 {size} 个体素，而体数据有 {volume} 个。</translation>
    </message>
    <message>
        <source>{file} cannot be used as walls: its spacing, origin or direction are not the volume's.</source>
        <translation>{file} 不能用作屏障：其间距、原点或方向与体数据不同。</translation>
    </message>
    <message>
        <source>{file} cannot be used as walls: all of its voxels are 0.</source>
        <translation>{file} 不能用作屏障：其所有体素均为 0。</translation>
    </message>
    <message>
        <source>{file} holds no object: all of its voxels are 0.</source>
        <translation>{file} 中没有目标：其所有体素均为 0。</translation>
    </message>
    <message>
        <source>{file} is hardly a label map: it has more than {most:0f} different values.</source>
        <translation>{file} 不像是标签图：其中有超过 {most:0f} 种不同的值。</translation>
    </message>
    <message>
        <source>{file} does not belong to this volume: a surface in it ({object}) lies outside of it.</source>
        <translation>{file} 不属于此体数据：其中的一个表面（{object}）位于体数据之外。</translation>
    </message>
    <message>
        <source>{file} is a folder, not a session.</source>
        <translation>{file} 是文件夹，不是会话。</translation>
    </message>
    <message>
        <source>{file} cannot be opened: {cause}.</source>
        <translation>无法打开 {file}：{cause}。</translation>
    </message>
    <message>
        <source>{file} cannot be read.</source>
        <translation>无法读取 {file}。</translation>
    </message>
    <message>
        <source>{file} is not a JSON file.</source>
        <translation>{file} 不是 JSON 文件。</translation>
    </message>
    <message>
        <source>{file} is neither a session nor a report: {cause}</source>
        <translation>{file} 既不是会话也不是报告：{cause}</translation>
    </message>
    <message>
        <source>it holds no objects.</source>
        <translation>其中没有目标。</translation>
    </message>
    <message>
        <source>it has no seeds.</source>
        <translation>其中没有种子点。</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>没有此文件</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>没有此文件或文件夹</translation>
    </message>
    <message>
        <source>it is not a file</source>
        <translation>这不是文件</translation>
    </message>
    <message>
        <source>it is neither a file nor a folder</source>
        <translation>这既不是文件也不是文件夹</translation>
    </message>
    <message>
        <source>it cannot be opened (permission?)</source>
        <translation>无法打开（是否缺少权限？）</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>无法打开</translation>
    </message>
    <message>
        <source>it cannot be read</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>it cannot be read to its end</source>
        <translation>无法读到末尾</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>文件为空</translation>
    </message>
    <message>
        <source>the folder cannot be read</source>
        <translation>无法读取文件夹</translation>
    </message>
    <message>
        <source>the folder cannot be read ({reason})</source>
        <translation>无法读取文件夹（{reason}）</translation>
    </message>
    <message>
        <source>there is not enough memory to read it</source>
        <translation>内存不足，无法读取</translation>
    </message>
    <message>
        <source>not enough memory to decompress it</source>
        <translation>内存不足，无法解压</translation>
    </message>
    <message>
        <source>it is truncated or damaged</source>
        <translation>文件被截断或已损坏</translation>
    </message>
    <message>
        <source>it is truncated or damaged ({reason})</source>
        <translation>文件被截断或已损坏（{reason}）</translation>
    </message>
    <message>
        <source>its {format} header cannot be read ({reason})</source>
        <translation>无法读取其 {format} 文件头（{reason}）</translation>
    </message>
    <message>
        <source>it is truncated within its {format} header</source>
        <translation>文件在其 {format} 文件头内被截断</translation>
    </message>
    <message>
        <source>its {format} header is truncated</source>
        <translation>其 {format} 文件头被截断</translation>
    </message>
    <message>
        <source>its {format} header is truncated (no {field})</source>
        <translation>其 {format} 文件头被截断（缺少 {field}）</translation>
    </message>
    <message>
        <source>its {format} header is damaged ({field})</source>
        <translation>其 {format} 文件头已损坏（{field}）</translation>
    </message>
    <message>
        <source>the {format} file is damaged ({field})</source>
        <translation>{format} 文件已损坏（{field}）</translation>
    </message>
    <message>
        <source>the {format} file is truncated</source>
        <translation>{format} 文件被截断</translation>
    </message>
    <message>
        <source>it is not a {format} file</source>
        <translation>这不是 {format} 文件</translation>
    </message>
    <message>
        <source>it is not a volume in a known format (NIfTI, NRRD, MetaImage, DICOM, TIFF, GIPL)</source>
        <translation>这不是已知格式的体数据（NIfTI、NRRD、MetaImage、DICOM、TIFF、GIPL）</translation>
    </message>
    <message>
        <source>this is a Git LFS pointer, not the file it stands for</source>
        <translation>这是 Git LFS 指针，而不是它所代表的文件</translation>
    </message>
    <message>
        <source>this is a compressed DICOM file; unpack it first (gunzip)</source>
        <translation>这是压缩的 DICOM 文件；请先解压（gunzip）</translation>
    </message>
    <message>
        <source>this is a sequence of tracked 2D frames, not a volume; reconstruct a volume from it first</source>
        <translation>这是带跟踪的二维图像序列，不是体数据；请先由其重建体数据</translation>
    </message>
    <message>
        <source>this is a 2D image, a volume is needed</source>
        <translation>这是二维图像，需要体数据</translation>
    </message>
    <message>
        <source>this is a 2D image, a volume needs at least two slices along each axis</source>
        <translation>这是二维图像，体数据沿每个轴至少需要两层</translation>
    </message>
    <message>
        <source>this looks like a 2D image in colour (its first axis has {values:0f} values, and the header says nothing of space)</source>
        <translation>这看来是彩色二维图像（其第一个轴有 {values:0f} 个值，且文件头未说明空间信息）</translation>
    </message>
    <message>
        <source>the volume has no voxels (a size of 0)</source>
        <translation>体数据没有体素（有一个尺寸为 0）</translation>
    </message>
    <message>
        <source>the volume has no voxels (a size of 0 in its header)</source>
        <translation>体数据没有体素（文件头中有一个尺寸为 0）</translation>
    </message>
    <message>
        <source>its voxel spacing is zero, negative or not a number</source>
        <translation>其体素间距为零、为负或不是数字</translation>
    </message>
    <message>
        <source>its position or its direction is not a number</source>
        <translation>其位置或方向不是数字</translation>
    </message>
    <message>
        <source>its axes are not at right angles (sheared or tilted), which is not supported</source>
        <translation>其坐标轴不成直角（剪切或倾斜），不受支持</translation>
    </message>
    <message>
        <source>it has no time points</source>
        <translation>其中没有时间点</translation>
    </message>
    <message>
        <source>the number of its time points is implausible ({frames:0f})</source>
        <translation>其时间点数目不合理（{frames:0f}）</translation>
    </message>
    <message>
        <source>it declares {declared_gb:1f} GB of voxels, more than the {memory_gb:1f} GB of memory of this computer</source>
        <translation>其声明的体素数据为 {declared_gb:1f} GB，超过本机的 {memory_gb:1f} GB 内存</translation>
    </message>
    <message>
        <source>a size in its header is implausible ({size})</source>
        <translation>文件头中有一个尺寸不合理（{size}）</translation>
    </message>
    <message>
        <source>its data file {data} is missing</source>
        <translation>缺少其数据文件 {data}</translation>
    </message>
    <message>
        <source>it is truncated or damaged: the header declares {declared:0f} bytes of voxels, the file holds {held:0f}</source>
        <translation>文件被截断或已损坏：文件头声明 {declared:0f} 字节的体素，文件中有 {held:0f} 字节</translation>
    </message>
    <message>
        <source>it is truncated or damaged: the header declares {declared:0f} bytes of voxels, the file holds {held:0f} compressed</source>
        <translation>文件被截断或已损坏：文件头声明 {declared:0f} 字节的体素，文件中有压缩后的 {held:0f} 字节</translation>
    </message>
    <message>
        <source>its voxel data are truncated or damaged</source>
        <translation>其体素数据被截断或已损坏</translation>
    </message>
    <message>
        <source>the voxel data are truncated or damaged</source>
        <translation>体素数据被截断或已损坏</translation>
    </message>
    <message>
        <source>the compressed voxel data are truncated or damaged (checksum)</source>
        <translation>压缩的体素数据被截断或已损坏（校验和）</translation>
    </message>
    <message>
        <source>1 of its voxels is infinite, the first at index ({index: 0f})</source>
        <translation>有 1 个体素为无穷大，位于索引 ({index: 0f})</translation>
    </message>
    <message>
        <source>{voxels:0f} of its voxels are infinite, the first at index ({index: 0f})</source>
        <translation>有 {voxels:0f} 个体素为无穷大，首个位于索引 ({index: 0f})</translation>
    </message>
    <message>
        <source>none of its voxels is a number</source>
        <translation>没有一个体素是数字</translation>
    </message>
    <message>
        <source>its voxels have {components} components (vectors); only scalar and colour volumes are supported</source>
        <translation>其体素有 {components} 个分量（向量）；仅支持标量和彩色体数据</translation>
    </message>
    <message>
        <source>it has more than four dimensions</source>
        <translation>其维数超过四</translation>
    </message>
    <message>
        <source>it has {dimensions:0f} dimensions; at most four are supported</source>
        <translation>其维数为 {dimensions:0f}；最多支持四维</translation>
    </message>
    <message>
        <source>its voxel type ({type}) is not supported</source>
        <translation>不支持其体素类型（{type}）</translation>
    </message>
    <message>
        <source>its voxel type is not supported</source>
        <translation>不支持其体素类型</translation>
    </message>
    <message>
        <source>its NIfTI voxel type {type} is not supported</source>
        <translation>不支持其 NIfTI 体素类型 {type}</translation>
    </message>
    <message>
        <source>it is not a NIfTI file, whatever its name says</source>
        <translation>无论文件名如何，这都不是 NIfTI 文件</translation>
    </message>
    <message>
        <source>this is an Analyze 7.5 file, whose orientation is not reliable; convert it to NIfTI</source>
        <translation>这是 Analyze 7.5 文件，其方向不可靠；请转换为 NIfTI</translation>
    </message>
    <message>
        <source>the sform in its header has an axis without length</source>
        <translation>文件头中的 sform 有长度为零的轴</translation>
    </message>
    <message>
        <source>the sform in its header is not a number</source>
        <translation>文件头中的 sform 不是数字</translation>
    </message>
    <message>
        <source>its list of data files ({pattern}) is not supported</source>
        <translation>不支持其数据文件列表（{pattern}）</translation>
    </message>
    <message>
        <source>its encoding ({encoding}) is not supported; raw, gzip and ascii are</source>
        <translation>不支持其编码（{encoding}）；支持 raw、gzip 和 ascii</translation>
    </message>
    <message>
        <source>its data files do not divide its voxels evenly</source>
        <translation>其数据文件未均匀划分体素</translation>
    </message>
    <message>
        <source>its byte skip of -1 is not supported here</source>
        <translation>此处不支持其 byte skip 为 -1</translation>
    </message>
    <message>
        <source>its voxels are not numbers ({word})</source>
        <translation>其体素不是数字（{word}）</translation>
    </message>
    <message>
        <source>its voxels are spread over many data files, which is not supported</source>
        <translation>其体素分散在多个数据文件中，不受支持</translation>
    </message>
    <message>
        <source>its voxels are written as text, which is not supported</source>
        <translation>其体素以文本形式写入，不受支持</translation>
    </message>
    <message>
        <source>it has {frames:0f} time points; of the volumes of a folder each is one time point</source>
        <translation>它有 {frames:0f} 个时间点；文件夹中的每个体数据只对应一个时间点</translation>
    </message>
    <message>
        <source>its size, spacing or place is not the same as in {first}; the volumes of a folder are the time points of one</source>
        <translation>其尺寸、间距或位置与 {first} 不同；文件夹中的体数据是同一体数据的各时间点</translation>
    </message>
    <message>
        <source>its voxels are not of the same type and scale as in {first}; the volumes of a folder are the time points of one</source>
        <translation>其体素的类型或标度与 {first} 不同；文件夹中的体数据是同一体数据的各时间点</translation>
    </message>
    <message>
        <source>it has {pages:0f} pages; of the TIFF files of a folder each is one slice</source>
        <translation>它有 {pages:0f} 页；文件夹中的每个 TIFF 文件都是一个切面</translation>
    </message>
    <message>
        <source>its size, resolution or type of voxels is not the same as in {first}; the TIFF files of a folder are the slices of one volume</source>
        <translation>它的大小、分辨率或体素类型与 {first} 中的不同；文件夹中的 TIFF 文件是同一体数据的切面</translation>
    </message>
    <message>
        <source>it is no label map: it has voxels whose values are no whole numbers</source>
        <translation>这不是标签图：有体素的值不是整数</translation>
    </message>
    <message>
        <source>the DICOM file is truncated or damaged</source>
        <translation>DICOM 文件被截断或已损坏</translation>
    </message>
    <message>
        <source>the file {part} is truncated or damaged</source>
        <translation>文件 {part} 被截断或已损坏</translation>
    </message>
    <message>
        <source>the file {part} is truncated (cut off within its first 132 bytes)</source>
        <translation>文件 {part} 被截断（在前 132 字节内）</translation>
    </message>
    <message>
        <source>the file {part} is truncated (a slice without an image)</source>
        <translation>文件 {part} 被截断（切面中没有图像）</translation>
    </message>
    <message>
        <source>the DICOM header of {part} cannot be read ({reason})</source>
        <translation>无法读取 {part} 的 DICOM 文件头（{reason}）</translation>
    </message>
    <message>
        <source>it is not a DICOM image (no rows and columns)</source>
        <translation>这不是 DICOM 图像（没有行和列）</translation>
    </message>
    <message>
        <source>the folder holds no DICOM images</source>
        <translation>文件夹中没有 DICOM 图像</translation>
    </message>
    <message>
        <source>the folder holds no DICOM images itself; open one of its subfolders</source>
        <translation>文件夹本身没有 DICOM 图像；请打开其子文件夹</translation>
    </message>
    <message>
        <source>the slice {slice} does not say where it lies (position, orientation or pixel spacing)</source>
        <translation>切面 {slice} 未说明其所在（位置、方向或像素间距）</translation>
    </message>
    <message>
        <source>the slice {slice} has a pixel spacing that is not positive</source>
        <translation>切面 {slice} 的像素间距不为正</translation>
    </message>
    <message>
        <source>the slice {slice} has directions that span no plane</source>
        <translation>切面 {slice} 的方向不能张成平面</translation>
    </message>
    <message>
        <source>the slice {slice} has no pixels</source>
        <translation>切面 {slice} 没有像素</translation>
    </message>
    <message>
        <source>the slice {slice} cannot be opened</source>
        <translation>无法打开切面 {slice}</translation>
    </message>
    <message>
        <source>the slice {slice} cannot be read to its end</source>
        <translation>无法将切面 {slice} 读到末尾</translation>
    </message>
    <message>
        <source>the slice {slice} has another size than its header says</source>
        <translation>切面 {slice} 的尺寸与其文件头所声明的不同</translation>
    </message>
    <message>
        <source>the slice {slice} is truncated or damaged ({reason})</source>
        <translation>切面 {slice} 被截断或已损坏（{reason}）</translation>
    </message>
    <message>
        <source>the slice {slice} is truncated or damaged (its pixels cannot be decoded)</source>
        <translation>切面 {slice} 被截断或已损坏（无法解码其像素）</translation>
    </message>
    <message>
        <source>the slice {slice} is truncated or damaged: it holds less pixels than its header says</source>
        <translation>切面 {slice} 被截断或已损坏：其像素少于文件头所声明的</translation>
    </message>
    <message>
        <source>the slice {slice} is truncated or damaged: its header declares {declared:0f} bytes of pixels, the file holds {held:0f} compressed</source>
        <translation>切面 {slice} 被截断或已损坏：文件头声明 {declared:0f} 字节的像素，文件中有压缩后的 {held:0f} 字节</translation>
    </message>
    <message>
        <source>the slice {slice} is damaged: a value is larger than its header allows</source>
        <translation>切面 {slice} 已损坏：有一个值超出文件头允许的范围</translation>
    </message>
    <message>
        <source>its slices have different sizes</source>
        <translation>各切面尺寸不同</translation>
    </message>
    <message>
        <source>its slices have different orientations</source>
        <translation>各切面方向不同</translation>
    </message>
    <message>
        <source>its slices have different pixel spacings</source>
        <translation>各切面像素间距不同</translation>
    </message>
    <message>
        <source>its slices are partly in colour</source>
        <translation>部分切面为彩色</translation>
    </message>
    <message>
        <source>its slices are less than two pixels wide</source>
        <translation>各切面宽度不足两个像素</translation>
    </message>
    <message>
        <source>several of its slices lie in the same place with different content, and not equally many in every place (time points or echoes that are not complete)</source>
        <translation>多个切面位于同一位置而内容不同，且各位置数目不等（时间点或回波不完整）</translation>
    </message>
    <message>
        <source>all its slices lie in the same place: 2D images over time, not a volume</source>
        <translation>所有切面位于同一位置：这是随时间变化的二维图像，不是体数据</translation>
    </message>
    <message>
        <source>this is a single slice, a 2D image; give the folder with the whole series</source>
        <translation>这是单个切面，即二维图像；请给出包含整个序列的文件夹</translation>
    </message>
    <message>
        <source>its slices are shifted against each other by {shift_mm:4g} mm, more than they are apart; this is no gantry tilt</source>
        <translation>各切面彼此错位 {shift_mm:4g} mm，超过层间距；这不是机架倾斜</translation>
    </message>
    <message>
        <source>{cause}, too unevenly to resample</source>
        <translation>{cause}，过于不均而无法重采样</translation>
    </message>
    <message>
        <source>the number of frames in {slice} is implausible</source>
        <translation>{slice} 中的帧数不合理</translation>
    </message>
    <message>
        <source>pixels of {stored:0f} bits in {allocated:0f} are not supported ({slice})</source>
        <translation>不支持以 {allocated:0f} 位存储的 {stored:0f} 位像素（{slice}）</translation>
    </message>
    <message>
        <source>pixels with {samples:0f} samples are not supported ({slice})</source>
        <translation>不支持有 {samples:0f} 个采样值的像素（{slice}）</translation>
    </message>
    <message>
        <source>colour of {bits:0f} bits is not supported ({slice})</source>
        <translation>不支持 {bits:0f} 位彩色（{slice}）</translation>
    </message>
    <message>
        <source>compressed pixels of one bit are not supported ({slice})</source>
        <translation>不支持压缩的一位像素（{slice}）</translation>
    </message>
    <message>
        <source>the colour space {space} is not supported ({slice})</source>
        <translation>不支持色彩空间 {space}（{slice}）</translation>
    </message>
    <message>
        <source>it does not say which segment each frame is of</source>
        <translation>未说明每一帧属于哪个分割区段</translation>
    </message>
    <message>
        <source>it is a segmentation that is not binary ({bits:0f} bits per voxel), which is not supported</source>
        <translation>这是非二值分割（每体素 {bits:0f} 位），不受支持</translation>
    </message>
    <message>
        <source>its pixels are compressed, which is not supported for a segmentation</source>
        <translation>其像素经过压缩，对分割不受支持</translation>
    </message>
    <message>
        <source>it is truncated or damaged: it holds less pixels than its header says</source>
        <translation>文件被截断或已损坏：其像素少于文件头所声明的</translation>
    </message>
    <message>
        <source>it does not say where every frame lies</source>
        <translation>未说明每一帧的位置</translation>
    </message>
    <message>
        <source>its frames do not lie one behind the other, which is not supported</source>
        <translation>各帧并非前后排列，不受支持</translation>
    </message>
    <message>
        <source>it does not give the distance between its slices</source>
        <translation>未给出切面间距</translation>
    </message>
    <message>
        <source>the distance of its frames is implausible</source>
        <translation>各帧间距不合理</translation>
    </message>
    <message>
        <source>its frames are not evenly spaced</source>
        <translation>各帧间距不均</translation>
    </message>
    <message>
        <source>it cannot be read because the decoder {program} is not there</source>
        <translation>无法读取，因为缺少解码程序 {program}</translation>
    </message>
    <message>
        <source>the decoder cannot be started ({reason})</source>
        <translation>无法启动解码程序（{reason}）</translation>
    </message>
    <message>
        <source>the decoder {program} cannot be started ({reason})</source>
        <translation>无法启动解码程序 {program}（{reason}）</translation>
    </message>
    <message>
        <source>the decoder broke down on it ({how}); the file is damaged or too large for it</source>
        <translation>解码程序处理它时崩溃（{how}）；文件已损坏或过大</translation>
    </message>
    <message>
        <source>the decoder broke down on {part} ({how}); the file is damaged or too large for it</source>
        <translation>解码程序处理 {part} 时崩溃（{how}）；文件已损坏或过大</translation>
    </message>
    <message>
        <source>the decoder got stuck on it and was stopped; the file is damaged</source>
        <translation>解码程序处理它时卡住并被终止；文件已损坏</translation>
    </message>
    <message>
        <source>the decoder got stuck on {part} and was stopped; the file is damaged</source>
        <translation>解码程序处理 {part} 时卡住并被终止；文件已损坏</translation>
    </message>
    <message>
        <source>the decoder gave an answer without meaning</source>
        <translation>解码程序给出了无意义的回答</translation>
    </message>
    <message>
        <source>the decoder gave an answer without meaning on it</source>
        <translation>解码程序对它给出了无意义的回答</translation>
    </message>
    <message>
        <source>the decoder gave an answer without meaning on {part}</source>
        <translation>解码程序对 {part} 给出了无意义的回答</translation>
    </message>
    <message>
        <source>the decoder gave less than it announced</source>
        <translation>解码程序给出的数据少于其宣告的</translation>
    </message>
    <message>
        <source>decoding it takes more memory than its size allows</source>
        <translation>解码所需内存超过其大小所允许的</translation>
    </message>
    <message>
        <source>its data cannot be decoded ({reason})</source>
        <translation>无法解码其数据（{reason}）</translation>
    </message>
    <message>
        <source>the mesh file is truncated or damaged</source>
        <translation>网格文件被截断或已损坏</translation>
    </message>
    <message>
        <source>it is not an STL file, or it is truncated</source>
        <translation>这不是 STL 文件，或已被截断</translation>
    </message>
    <message>
        <source>triangle strips are not supported</source>
        <translation>不支持三角形条带</translation>
    </message>
    <message>
        <source>it holds no triangles</source>
        <translation>其中没有三角形</translation>
    </message>
    <message>
        <source>a coordinate is not a number or infinite</source>
        <translation>有坐标不是数字或为无穷大</translation>
    </message>
    <message>
        <source>a face names a vertex that is not there</source>
        <translation>有面引用了不存在的顶点</translation>
    </message>
    <message>
        <source>a face has less than three corners</source>
        <translation>有面少于三个顶点</translation>
    </message>
    <message>
        <source>a face is damaged</source>
        <translation>有面已损坏</translation>
    </message>
    <message>
        <source>a vertex is not three numbers</source>
        <translation>有顶点不是三个数字</translation>
    </message>
    <message>
        <source>its triangles have no area</source>
        <translation>其三角形没有面积</translation>
    </message>
    <message>
        <source>has no triangles</source>
        <translation>没有三角形</translation>
    </message>
    <message>
        <source>is not closed</source>
        <translation>未闭合</translation>
    </message>
    <message>
        <source>is not manifold</source>
        <translation>不是流形</translation>
    </message>
    <message>
        <source>has faces that are not oriented alike</source>
        <translation>有朝向不一致的面</translation>
    </message>
    <message>
        <source>intersects itself ({pairs:0f} pairs of faces)</source>
        <translation>自相交（{pairs:0f} 对面）</translation>
    </message>
    <message>
        <source>intersects itself in single precision</source>
        <translation>在单精度下自相交</translation>
    </message>
    <message>
        <source>has components that lie where they bound nothing</source>
        <translation>有连通分量所在之处未界定任何实体</translation>
    </message>
    <message>
        <source>encloses no volume</source>
        <translation>未围成体积</translation>
    </message>
    <message>
        <source>has no voxel of the value {label:0f}</source>
        <translation>没有值为 {label:0f} 的体素</translation>
    </message>
    <message>
        <source>has no voxel that is not 0</source>
        <translation>没有非 0 的体素</translation>
    </message>
    <message>
        <source>is a mesh, which has no labels</source>
        <translation>这是网格，没有标签</translation>
    </message>
    <message>
        <source>became surfaces without the label {label:0f}</source>
        <translation>转为表面后没有标签 {label:0f}</translation>
    </message>
    <message>
        <source>has labels that lie in each other so finely that their surfaces cannot be kept apart</source>
        <translation>标签相互嵌套过细，无法使其表面保持分离</translation>
    </message>
    <message>
        <source>has a surface of more than {most:0f} triangles</source>
        <translation>其表面超过 {most:0f} 个三角形</translation>
    </message>
    <message>
        <source>it is a folder, not a file name</source>
        <translation>这是文件夹，不是文件名</translation>
    </message>
    <message>
        <source>a folder has this name</source>
        <translation>有文件夹使用此名称</translation>
    </message>
    <message>
        <source>the data did not reach the disk (is it full?)</source>
        <translation>数据未写到磁盘（磁盘是否已满？）</translation>
    </message>
    <message>
        <source>the disk may be full</source>
        <translation>磁盘可能已满</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>无法打开文件</translation>
    </message>
    <message>
        <source>NIfTI cannot hold more than 32767 voxels or frames along an axis</source>
        <translation>NIfTI 沿一个轴最多容纳 32767 个体素或帧</translation>
    </message>
    <message>
        <source>the mesh is too large for DICOM</source>
        <translation>网格对 DICOM 而言过大</translation>
    </message>
    <message>
        <source>it is too large for DICOM</source>
        <translation>对 DICOM 而言过大</translation>
    </message>
    <message>
        <source>the mesh is too large for 3MF</source>
        <translation>网格对 3MF 而言过大</translation>
    </message>
    <message>
        <source>the object {object} holds the centre of no voxel</source>
        <translation>目标 {object} 不包含任何体素的中心</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>权限不足</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>磁盘空间不足</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>文件系统为只读</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>没有那个文件或文件夹</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>文件名过长</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>路径中有一部分不是文件夹</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>超出磁盘配额</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>输入/输出错误</translation>
    </message>
    <message>
        <source>The pin at {place} mm lies outside of the volume.</source>
        <translation>位于 {place} mm 的固定在体数据之外。</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies outside of the volume.</source>
        <translation>位于 {place} mm 的屏障在体数据之外。</translation>
    </message>
    <message>
        <source>The wall disc at {place} mm lies outside of the volume.</source>
        <translation>位于 {place} mm 的屏障圆盘在体数据之外。</translation>
    </message>
    <message>
        <source>The allowed place {place} lies outside of the volume.</source>
        <translation>允许的位置 {place} 在体数据之外。</translation>
    </message>
    <message>
        <source>The place to hold {place} lies outside of the volume.</source>
        <translation>要保持的位置 {place} 在体数据之外。</translation>
    </message>
    <message>
        <source>The surface to begin with, {file}, lies outside of the volume.</source>
        <translation>起始表面 {file} 在体数据之外。</translation>
    </message>
    <message>
        <source>The surface to begin with cannot become another one on the way: begin again.</source>
        <translation>起始表面不能在中途更换：请重新开始。</translation>
    </message>
    <message>
        <source>The object '{object}' has no mesh that could be a wall.</source>
        <translation>目标“{object}”没有可作为屏障的网格。</translation>
    </message>
    <message>
        <source>The label map of the walls has not the volume's size.</source>
        <translation>屏障的标签图与体数据大小不同。</translation>
    </message>
    <message>
        <source>An allowed place has nothing to allow: the components and the genus have no limit.</source>
        <translation>允许的位置没有可允许的内容：连通分量和亏格没有限制。</translation>
    </message>
    <message>
        <source>A place to hold has nothing to hold: the components and the genus have no limit.</source>
        <translation>要保持的位置没有可保持的内容：连通分量和亏格没有限制。</translation>
    </message>
    <message>
        <source>There is nothing to ask about: the components and the genus have no limit.</source>
        <translation>没有可询问的内容：连通分量和亏格没有限制。</translation>
    </message>
    <message>
        <source>A pin cannot be set before the first step of a correction: make a step first.</source>
        <translation>在修正的第一步之前不能设置固定：请先执行一步。</translation>
    </message>
    <message>
        <source>The sensitivity cannot be told of a growth with vetoes, pins or edits: they name an iteration, and a perturbed run has others.</source>
        <translation>带有否决、固定或编辑的生长无法给出敏感性：它们指定迭代，而扰动后的运行迭代不同。</translation>
    </message>
    <message>
        <source>The surface vanished.</source>
        <translation>表面已消失。</translation>
    </message>
    <message>
        <source>no DICOM file can be made: {cause}</source>
        <translation>无法生成 DICOM 文件：{cause}</translation>
    </message>
    <message>
        <source>the volume was not read from DICOM, and a DICOM file belongs to a patient and a study</source>
        <translation>体数据不是从 DICOM 读取的，而 DICOM 文件属于某一患者和检查</translation>
    </message>
    <message>
        <source>the series does not say where its slices lie</source>
        <translation>该序列未说明其切面的位置</translation>
    </message>
    <message>
        <source>its positions are in the frame of the ultrasound volume, not of the patient</source>
        <translation>其位置以超声体数据为参照，而非患者</translation>
    </message>
    <message>
        <source>its spacing was given by the user, not by the series</source>
        <translation>其间距由用户给出，而非来自序列</translation>
    </message>
    <message>
        <source>'{text}' is longer than 64 bytes</source>
        <translation>“{text}”超过 64 字节</translation>
    </message>
    <message>
        <source>'{text}' holds a control character or a backslash</source>
        <translation>“{text}”含有控制字符或反斜杠</translation>
    </message>
    <message>
        <source>the label map is not on the grid of the series</source>
        <translation>标签图不在该序列的网格上</translation>
    </message>
    <message>
        <source>tetrahedra are made by gmsh or TetGen, and neither program is installed (Debian's packages are gmsh and tetgen)</source>
        <translation>四面体由 gmsh 或 TetGen 生成，而两者均未安装（Debian 软件包为 gmsh 和 tetgen）</translation>
    </message>
    <message>
        <source>there are no tetrahedra of the object '{object}': {cause}.</source>
        <translation>目标“{object}”没有四面体：{cause}。</translation>
    </message>
    <message>
        <source>{file}: there is no frame {frame:0f}; it has the frames 0 to {last:0f}.</source>
        <translation>{file}：没有第 {frame:0f} 帧；共有第 0 至 {last:0f} 帧。</translation>
    </message>
    <message>
        <source>{file}: there is no frame {frame:0f}; it has one frame, 0.</source>
        <translation>{file}：没有第 {frame:0f} 帧；只有一帧，即第 0 帧。</translation>
    </message>
    <message>
        <source>the slice {slice} holds less frames than its header says</source>
        <translation>切面 {slice} 包含的帧数少于其文件头所声明的</translation>
    </message>
    <message>
        <source>the palette of {slice} is missing or damaged</source>
        <translation>{slice} 的调色板缺失或已损坏</translation>
    </message>
    <message>
        <source>There are {frames:0f} time points; frame 0 is used (step 1, Open, chooses another).</source>
        <translation>共有 {frames:0f} 个时间点；使用第 0 帧（可在第 1 步“打开”中另选）。</translation>
    </message>
    <message>
        <source>The volume is uncalibrated: its file does not give the spacing, 1 mm is assumed where it is missing, and lengths and volumes mean nothing until it is entered in step 1, Open.</source>
        <translation>体数据未校准：其文件未给出间距，缺失处假定为 1 mm；在第 1 步“打开”中输入之前，长度和体积没有意义。</translation>
    </message>
    <message>
        <source>stack {stack:0f} ({slices:0f} slices)</source>
        <translation>堆栈 {stack:0f}（{slices:0f} 层）</translation>
    </message>
    <message>
        <source>it holds {series:0f} series or stacks, choose one in step 1, Open: {choices}</source>
        <translation>其中有 {series:0f} 个序列或堆栈，请在第 1 步“打开”中选择一个：{choices}</translation>
    </message>
    <message>
        <source>No point of the lattice lies in A or B: there is no Dice coefficient.</source>
        <translation>没有网格点位于 A 或 B 内：没有 Dice 系数。</translation>
    </message>
    <message>
        <source>its slices are unevenly spaced ({list})</source>
        <translation>各切面间距不均（{list}）</translation>
    </message>
    <message>
        <source>its slices are unevenly spaced ({list}), 1 seems to be missing</source>
        <translation>各切面间距不均（{list}），似乎缺少 1 层</translation>
    </message>
    <message>
        <source>its slices are unevenly spaced ({list}), {missing:0f} seem to be missing</source>
        <translation>各切面间距不均（{list}），似乎缺少 {missing:0f} 层</translation>
    </message>
    <message>
        <source>1 gap of {gap_mm:4g} mm</source>
        <translation>1 处 {gap_mm:4g} mm 的间隔</translation>
    </message>
    <message>
        <source>{gaps:0f} gaps of {gap_mm:4g} mm</source>
        <translation>{gaps:0f} 处 {gap_mm:4g} mm 的间隔</translation>
    </message>
    <message>
        <source>{gaps:0f} of {gap_mm:4g} mm</source>
        <translation>{gaps:0f} 处 {gap_mm:4g} mm</translation>
    </message>
    <message>
        <source>{gaps:0f} of {gap_mm:4g} mm …</source>
        <translation>{gaps:0f} 处 {gap_mm:4g} mm……</translation>
    </message>
    <message>
        <source>Colour was turned into luminance (0.2125 R + 0.7154 G + 0.0721 B).</source>
        <translation>彩色已转换为亮度（0.2125 R + 0.7154 G + 0.0721 B）。</translation>
    </message>
    <message>
        <source>The distance unit {unit} is taken as millimetres.</source>
        <translation>距离单位 {unit} 按毫米处理。</translation>
    </message>
    <message>
        <source>The space units {units} are taken as millimetres.</source>
        <translation>空间单位 {units} 按毫米处理。</translation>
    </message>
    <message>
        <source>The lengths in the header are in metres and were turned into millimetres.</source>
        <translation>文件头中的长度以米为单位，已换算为毫米。</translation>
    </message>
    <message>
        <source>The lengths in the header are in micrometres and were turned into millimetres.</source>
        <translation>文件头中的长度以微米为单位，已换算为毫米。</translation>
    </message>
    <message>
        <source>The header does not say how the volume lies in space (qform and sform codes are 0).</source>
        <translation>文件头未说明体数据在空间中的方位（qform 和 sform 的代码均为 0）。</translation>
    </message>
    <message>
        <source>The header does not say how the volume lies in space; its axes are taken as LPS.</source>
        <translation>文件头未说明体数据在空间中的方位；其各轴按 LPS 处理。</translation>
    </message>
    <message>
        <source>The sform and the qform of the header disagree (by up to {apart_mm:0f} mm); the qform is used.</source>
        <translation>文件头中的 sform 与 qform 不一致（相差最多 {apart_mm:0f} mm）；使用 qform。</translation>
    </message>
    <message>
        <source>TIFF does not say how far apart the slices are nor how they lie; 1 mm and LPS axes are assumed.</source>
        <translation>TIFF 既未说明切面间距也未说明其方位；假定为 1 mm 和 LPS 轴。</translation>
    </message>
    <message>
        <source>This is a segmentation: its voxels hold the numbers of the segments.</source>
        <translation>这是分割：其体素存放各分段的编号。</translation>
    </message>
    <message>
        <source>The spacing was given by the user; the file says {x_mm:4g} mm, {y_mm:4g} mm, {z_mm:4g} mm.</source>
        <translation>间距由用户给出；文件中为 {x_mm:4g} mm、{y_mm:4g} mm、{z_mm:4g} mm。</translation>
    </message>
    <message>
        <source>{none:0f} of {voxels:0f} voxels are not a number: they count as outside of the field of view.</source>
        <translation>{voxels:0f} 个体素中有 {none:0f} 个不是数字：它们视为位于视野之外。</translation>
    </message>
    <message>
        <source>1 slice is a copy of another and was left out.</source>
        <translation>1 个切面是另一切面的副本，已略去。</translation>
    </message>
    <message>
        <source>{copies:0f} slices are copies of others and were left out.</source>
        <translation>{copies:0f} 个切面是其他切面的副本，已略去。</translation>
    </message>
    <message>
        <source>The slices are tilted by {degrees:1f} degrees (gantry tilt) and were resampled to a straight grid.</source>
        <translation>各切面倾斜 {degrees:1f} 度（机架倾斜），已重采样到正交网格。</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced ({list}); they were resampled to a distance of {spacing_mm:4g} mm. What lies in the gaps is interpolated.</source>
        <translation>各切面间距不均（{list}）；已按 {spacing_mm:4g} mm 的间距重采样。间隔中的内容由插值得到。</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced ({list}), 1 seems to be missing; they were resampled to a distance of {spacing_mm:4g} mm. What lies in the gaps is interpolated.</source>
        <translation>各切面间距不均（{list}），似乎缺少 1 层；已按 {spacing_mm:4g} mm 的间距重采样。间隔中的内容由插值得到。</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced ({list}), {missing:0f} seem to be missing; they were resampled to a distance of {spacing_mm:4g} mm. What lies in the gaps is interpolated.</source>
        <translation>各切面间距不均（{list}），似乎缺少 {missing:0f} 层；已按 {spacing_mm:4g} mm 的间距重采样。间隔中的内容由插值得到。</translation>
    </message>
    <message>
        <source>The header does not say where the slices lie; they are taken one behind the other, with LPS axes.</source>
        <translation>文件头未说明切面的位置；按前后依次排列、LPS 轴处理。</translation>
    </message>
    <message>
        <source>The file does not say how the volume lies in the patient: columns are taken to run to the right, rows to the back and slices downwards.</source>
        <translation>文件未说明体数据在患者体内的方位：假定列向右、行向后、切面向下排列。</translation>
    </message>
    <message>
        <source>The file breaks off: its header declares {frames:0f} time points, and only the first one is there in full.</source>
        <translation>文件中断：文件头声明有 {frames:0f} 个时间点，只有第一个完整。</translation>
    </message>
    <message>
        <source>The file breaks off: its header declares {frames:0f} time points, and only the first {whole:0f} are there in full.</source>
        <translation>文件中断：文件头声明有 {frames:0f} 个时间点，只有前 {whole:0f} 个完整。</translation>
    </message>
    <message>
        <source>1 file of DICOM in the folder is without an image and left out.</source>
        <translation>文件夹中有 1 个 DICOM 文件不含图像，已略去。</translation>
    </message>
    <message>
        <source>{files:0f} files of DICOM in the folder are without an image and left out.</source>
        <translation>文件夹中有 {files:0f} 个 DICOM 文件不含图像，已略去。</translation>
    </message>
    <message>
        <source>1 file of other series is truncated or damaged.</source>
        <translation>其他序列中有 1 个文件被截断或已损坏。</translation>
    </message>
    <message>
        <source>{files:0f} files of other series are truncated or damaged.</source>
        <translation>其他序列中有 {files:0f} 个文件被截断或已损坏。</translation>
    </message>
    <message>
        <source>1 file in the folder is not DICOM and left out: {names}.</source>
        <translation>文件夹中有 1 个文件不是 DICOM，已略去：{names}。</translation>
    </message>
    <message>
        <source>{files:0f} files in the folder are not DICOM and left out: {names}.</source>
        <translation>文件夹中有 {files:0f} 个文件不是 DICOM，已略去：{names}。</translation>
    </message>
    <message>
        <source>{files:0f} files in the folder are not DICOM and left out: {names} and {more:0f} more.</source>
        <translation>文件夹中有 {files:0f} 个文件不是 DICOM，已略去：{names} 及另外 {more:0f} 个。</translation>
    </message>
    <message>
        <source>1 file in the folder is not DICOM and left out.</source>
        <translation>文件夹中有 1 个文件不是 DICOM，已略去。</translation>
    </message>
    <message>
        <source>{files:0f} files in the folder are not DICOM and left out.</source>
        <translation>文件夹中有 {files:0f} 个文件不是 DICOM，已略去。</translation>
    </message>
    <message>
        <source>Its stacks of one pitch each are to be had alone: {list}.</source>
        <translation>其间距各自均匀的堆栈可单独打开：{list}。</translation>
    </message>
    <message>
        <source>Its stacks of one pitch each are to be had alone.</source>
        <translation>其间距各自均匀的堆栈可单独打开。</translation>
    </message>
    <message>
        <source>Nothing is chosen: {cause}.</source>
        <translation>尚未选择：{cause}。</translation>
    </message>
    <message>
        <source>{series} ({what}1 file, {size} voxels of {spacing_mm: 4g} mm)</source>
        <translation>{series}（{what}1 个文件，{size} 个体素，{spacing_mm: 4g} mm）</translation>
    </message>
    <message>
        <source>{series} ({what}{files:0f} files, {size} voxels of {spacing_mm: 4g} mm)</source>
        <translation>{series}（{what}{files:0f} 个文件，{size} 个体素，{spacing_mm: 4g} mm）</translation>
    </message>
    <message>
        <source>{series} ({what}1 file, no volume)</source>
        <translation>{series}（{what}1 个文件，不是体数据）</translation>
    </message>
    <message>
        <source>{series} ({what}{files:0f} files, no volume)</source>
        <translation>{series}（{what}{files:0f} 个文件，不是体数据）</translation>
    </message>
    <message>
        <source>{cause}.</source>
        <translation>{cause}。</translation>
    </message>
    <message>
        <source>{object}: {cause}</source>
        <translation>{object}：{cause}</translation>
    </message>
    <message>
        <source>{object} is empty: there are no distances.</source>
        <translation>{object} 为空：没有距离。</translation>
    </message>
    <message>
        <source>{object} is not closed: it has no volume, and there is no Dice coefficient. Distances are measured from and to what there is of its surface.</source>
        <translation>{object} 未闭合：没有体积，也没有 Dice 系数。距离按其现有的表面计算。</translation>
    </message>
    <message>
        <source>{object} is closed, but not all of its faces are oriented alike: it has no volume, and there is no Dice coefficient.</source>
        <translation>{object} 已闭合，但各面朝向不一致：没有体积，也没有 Dice 系数。</translation>
    </message>
    <message>
        <source>{object} is not a manifold: its genus and cavities cannot be counted.</source>
        <translation>{object} 不是流形：无法计算其亏格和空腔。</translation>
    </message>
    <message>
        <source>{object} is inside out; it was turned.</source>
        <translation>{object} 内外颠倒，已翻转。</translation>
    </message>
    <message>
        <source>A and B do not overlap: their surfaces are {apart_mm:4g} mm apart, the centres of their boxes {centres_mm:4g} mm.</source>
        <translation>A 与 B 不重叠：它们的表面相距 {apart_mm:4g} mm，包围盒的中心相距 {centres_mm:4g} mm。</translation>
    </message>
    <message>
        <source>A and B do not overlap: their surfaces are {apart_mm:4g} mm apart, the centres of their boxes {centres_mm:4g} mm. With the signs of x and y turned in one of them they would meet: is one in RAS and does not say so?</source>
        <translation>A 与 B 不重叠：它们的表面相距 {apart_mm:4g} mm，包围盒的中心相距 {centres_mm:4g} mm。若将其中之一的 x 和 y 变号，它们就会相交：是否有一个采用 RAS 而未注明？</translation>
    </message>
    <message>
        <source>A part of the surface lies outside of the volume: intensities and label maps are of the rest.</source>
        <translation>表面有一部分位于体数据之外：强度和标签图取自其余部分。</translation>
    </message>
    <message>
        <source>{voxels:0f} voxels inside have no finite value and do not count.</source>
        <translation>内部有 {voxels:0f} 个体素没有有限值，不计入。</translation>
    </message>
    <message>
        <source>No voxel with a value has its centre inside.</source>
        <translation>没有任何有值体素的中心位于内部。</translation>
    </message>
    <message>
        <source>“{object}” has no cavity, and so no wall around one.</source>
        <translation>“{object}”没有空腔，因此没有腔壁。</translation>
    </message>
    <message>
        <source>Positions are in the frame of the ultrasound volume, not of the patient: its axes are taken as LPS.</source>
        <translation>位置以超声体数据为参照，而非患者：其各轴按 LPS 处理。</translation>
    </message>
    <message>
        <source>MONOCHROME1: low values are bright on a display.</source>
        <translation>MONOCHROME1：低值在显示时为亮。</translation>
    </message>
    <message>
        <source>The header scales voxels by 0, which would make them all alike; 1 is taken instead.</source>
        <translation>文件头将体素乘以 0，这会使所有体素相同；改用 1。</translation>
    </message>
    <message>
        <source>it holds several series or stacks, choose one in step 1, Open</source>
        <translation>其中有多个序列或堆栈，请在第 1 步“打开”中选择一个</translation>
    </message>
    <message>
        <source>This session does not say where its volume is. Choose it.</source>
        <translation>此会话未说明其体数据的位置。请选择。</translation>
    </message>
    <message>
        <source>This session does not say where the label map of its walls is. Choose it.</source>
        <translation>此会话未说明其壁的标签图的位置。请选择。</translation>
    </message>
    <message>
        <source>This session does not say where the file of a surface is that an object begins with. Choose it.</source>
        <translation>此会话未说明某个对象起始表面的文件位置。请选择。</translation>
    </message>
    <message>
        <source>{file}: series {series} is not the one that the session was made from: its voxels differ.</source>
        <translation>{file}：序列 {series} 不是创建该会话时所用的序列：其体素不同。</translation>
    </message>
    <message>
        <source>{file}: none of its series has the voxels that the session was made from.</source>
        <translation>{file}：其中没有任何序列具有创建该会话时所用的体素。</translation>
    </message>
    <message>
        <source>the surface does not enclose the seed at {place:1f} mm, which lies {distance_mm:1f} mm outside of it: the image or other clicks speak against it</source>
        <translation>表面未包围位于 {place:1f} mm 的种子点，该点在表面外 {distance_mm:1f} mm：图像或其他点与之不符</translation>
    </message>
    <message>
        <source>the surface encloses the click outside of the object at {place:1f} mm, which lies {distance_mm:1f} mm within it: the image or other clicks speak against it</source>
        <translation>表面包围了位于 {place:1f} mm 的外部点，该点在表面内 {distance_mm:1f} mm：图像或其他点与之不符</translation>
    </message>
    <message>
        <source>The seed at {place:1f} mm and the click outside of the object at {outside:1f} mm contradict each other: both lie in one voxel.</source>
        <translation>位于 {place:1f} mm 的种子点与位于 {outside:1f} mm 的外部点相互矛盾：两者在同一体素内。</translation>
    </message>
    <message>
        <source>the mesh is written as it was given: triangles with an angle under 15 degrees: {thin_faces:0f}, edges whose faces meet at less than 20 degrees: {sharp_edges:0f} (handlebody-cli edit --polish all betters them)</source>
        <translation>网格按给定的原样写出：有小于 15 度角的三角形：{thin_faces:0f} 个，两面夹角小于 20 度的边：{sharp_edges:0f} 条（handlebody-cli edit --polish all 可改善）</translation>
    </message>
    <message>
        <source>The segmentation has {layers:0f} layers, since segments overlap: only the segments of the first layer are read.</source>
        <translation>该分割有 {layers:0f} 层，因为有分割区重叠：只读取第一层的分割区。</translation>
    </message>
    <message>
        <source>labels of the map that was given overlap: {voxels:0f} voxels of this one are left to smaller ones that hold them, too</source>
        <translation>所给标签图中的标签有重叠：此标签的 {voxels:0f} 个体素留给了同样包含它们的较小标签</translation>
    </message>
    <message>
        <source>it has no label called '{name}'; it has: {names}</source>
        <translation>其中没有名为“{name}”的标签；有：{names}</translation>
    </message>
    <message>
        <source>it has no label called '{name}': it names none</source>
        <translation>其中没有名为“{name}”的标签：它没有给任何标签命名</translation>
    </message>
    <message>
        <source>it has several labels called '{name}': their number tells them apart</source>
        <translation>其中有多个名为“{name}”的标签：请用编号区分</translation>
    </message>
    <message>
        <source>has no voxel of the label {label:0f} that no smaller label holds, too</source>
        <translation>标签 {label:0f} 没有一个体素不同时属于更小的标签</translation>
    </message>
    <message>
        <source>has {tunnels:0f} tunnels, and no closing or opening leaves {most:0f} or fewer</source>
        <translation>有 {tunnels:0f} 个隧道，闭运算或开运算都不能使其不超过 {most:0f} 个</translation>
    </message>
    <message>
        <source>The surface to begin with, {file}, meets the object '{object}', which comes before it. Labels of one map that touch are kept apart where they are opened together, with the same smoothing, largest part and tunnels.</source>
        <translation>起始表面 {file} 与排在其前的目标“{object}”相遇。同一标签图中相互接触的标签，只有一起打开且平滑、最大部分和隧道的设置相同时才会保持分开。</translation>
    </message>
    <message>
        <source>it is not a mesh file (.stl, .vtp, .ply, .obj, .3mf, .stl.dcm)</source>
        <translation>这不是网格文件（.stl、.vtp、.ply、.obj、.3mf、.stl.dcm）</translation>
    </message>
    <message>
        <source>it is encrypted</source>
        <translation>该文件已加密</translation>
    </message>
    <message>
        <source>it needs an extension of {format} that is not supported ({extension})</source>
        <translation>它需要不受支持的 {format} 扩展（{extension}）</translation>
    </message>
    <message>
        <source>an object begins with one surface or is one, not both.</source>
        <translation>目标要么以一个表面开始，要么本身就是一个表面，不能两者兼有。</translation>
    </message>
    <message>
        <source>The balloon weight must be a number above 0.</source>
        <translation>气球力的权重必须是大于 0 的数。</translation>
    </message>
    <message>
        <source>The curvature weight must be a number of at least 0.</source>
        <translation>曲率的权重必须是不小于 0 的数。</translation>
    </message>
    <message>
        <source>The number of iterations must not be negative.</source>
        <translation>迭代次数不能为负。</translation>
    </message>
    <message>
        <source>The number of threads must be between 0 and 1024.</source>
        <translation>线程数必须在 0 到 1024 之间。</translation>
    </message>
    <message>
        <source>The smoothing must be at least 0 mm.</source>
        <translation>平滑至少应为 0 mm。</translation>
    </message>
    <message>
        <source>The edge length must be above 0 mm.</source>
        <translation>边长必须大于 0 mm。</translation>
    </message>
    <message>
        <source>The smoothing of {given_mm} mm is too large for a volume whose longest side is {longest_mm} mm: at most {most_mm} mm.</source>
        <translation>平滑 {given_mm} mm 对最长边为 {longest_mm} mm 的体数据来说过大：最多 {most_mm} mm。</translation>
    </message>
    <message>
        <source>The edge length of {given_mm} mm is too large for a volume whose longest side is {longest_mm} mm: at most {most_mm} mm.</source>
        <translation>边长 {given_mm} mm 对最长边为 {longest_mm} mm 的体数据来说过大：最多 {most_mm} mm。</translation>
    </message>
    <message>
        <source>The number of components must be at least 1.</source>
        <translation>连通分量的个数至少为 1。</translation>
    </message>
    <message>
        <source>The genus must be at least 0.</source>
        <translation>亏格至少为 0。</translation>
    </message>
    <message>
        <source>The wall at {place} has no radius above 0 mm.</source>
        <translation>位于 {place} 的屏障没有大于 0 mm 的半径。</translation>
    </message>
    <message>
        <source>The wall disc at {place} has no radius above 0 mm.</source>
        <translation>位于 {place} 的屏障圆盘没有大于 0 mm 的半径。</translation>
    </message>
    <message>
        <source>The wall disc at {place} mm has a normal of no length.</source>
        <translation>位于 {place} mm 的屏障圆盘的法向量长度为零。</translation>
    </message>
    <message>
        <source>The label map of the walls has not been read.</source>
        <translation>屏障的标签图尚未读取。</translation>
    </message>
    <message>
        <source>The surface to begin with, {file}, has not been read.</source>
        <translation>起始表面 {file} 尚未读取。</translation>
    </message>
    <message>
        <source>A veto needs an iteration of at least 1 and a place.</source>
        <translation>否决需要不小于 1 的迭代序号和一个位置。</translation>
    </message>
    <message>
        <source>Iteration {iteration:0f} is an edit: there is nothing that a veto could forbid.</source>
        <translation>第 {iteration:0f} 次迭代是一次编辑：没有可以否决的内容。</translation>
    </message>
    <message>
        <source>The pin at {place} has no radius above 0 mm.</source>
        <translation>位于 {place} 的固定没有大于 0 mm 的半径。</translation>
    </message>
    <message>
        <source>The pin at {place} mm has an iteration below 0.</source>
        <translation>位于 {place} mm 的固定的迭代序号小于 0。</translation>
    </message>
    <message>
        <source>An edit needs an iteration of at least 1 and a place.</source>
        <translation>编辑需要不小于 1 的迭代序号和一个位置。</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} has a number that is not finite.</source>
        <translation>第 {iteration:0f} 次迭代的编辑含有非有限的数。</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} has no radius above 0 mm.</source>
        <translation>第 {iteration:0f} 次迭代的编辑没有大于 0 mm 的半径。</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} has a radius below 0 mm.</source>
        <translation>第 {iteration:0f} 次迭代的编辑的半径小于 0 mm。</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} has a normal of no length.</source>
        <translation>第 {iteration:0f} 次迭代的编辑的法向量长度为零。</translation>
    </message>
    <message>
        <source>There are two edits of iteration {iteration:0f}: a step can be one only.</source>
        <translation>第 {iteration:0f} 次迭代有两次编辑：一步只能是一次编辑。</translation>
    </message>
    <message>
        <source>The veto of iteration {iteration:0f} has nothing to forbid: the growth ended at iteration {now:0f}.</source>
        <translation>第 {iteration:0f} 次迭代的否决没有可禁止的内容：生长在第 {now:0f} 次迭代结束。</translation>
    </message>
    <message>
        <source>The pin {pin} holds nothing: the growth ended at iteration {now:0f}.</source>
        <translation>固定 {pin} 没有固定任何东西：生长在第 {now:0f} 次迭代结束。</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} is never made: the growth ended at iteration {now:0f}.</source>
        <translation>第 {iteration:0f} 次迭代的编辑不会执行：生长在第 {now:0f} 次迭代结束。</translation>
    </message>
    <message>
        <source>The surface intersects itself in single precision: the volume lies too far from the origin.</source>
        <translation>表面在单精度下自相交：体数据离原点太远。</translation>
    </message>
    <message>
        <source>{sampling_mm:4g} mm between samples would take more than {most:0f} samples of these surfaces.</source>
        <translation>采样间距 {sampling_mm:4g} mm 需要对这些表面取超过 {most:0f} 个采样点。</translation>
    </message>
    <message>
        <source>{file}: it {cause}.</source>
        <translation>{file}：{cause}。</translation>
    </message>
    <message>
        <source>the {format} file is damaged ({cause})</source>
        <translation>{format} 文件已损坏（{cause}）</translation>
    </message>
    <message>
        <source>{part} is missing</source>
        <translation>缺少 {part}</translation>
    </message>
    <message>
        <source>object {object:0f} is missing</source>
        <translation>缺少对象 {object:0f}</translation>
    </message>
    <message>
        <source>object {object:0f} holds itself</source>
        <translation>对象 {object:0f} 包含其自身</translation>
    </message>
    <message>
        <source>two objects {object:0f}</source>
        <translation>有两个编号为 {object:0f} 的对象</translation>
    </message>
    <message>
        <source>an object without a number</source>
        <translation>有一个对象没有编号</translation>
    </message>
    <message>
        <source>too deeply nested components</source>
        <translation>组件嵌套过深</translation>
    </message>
    <message>
        <source>more than {most:0f} objects and components</source>
        <translation>对象和组件超过 {most:0f} 个</translation>
    </message>
    <message>
        <source>a component or an item without an object</source>
        <translation>有组件或条目没有对象</translation>
    </message>
    <message>
        <source>a transform that is not twelve numbers</source>
        <translation>有变换不是十二个数</translation>
    </message>
    <message>
        <source>unit {unit}</source>
        <translation>单位 {unit}</translation>
    </message>
    <message>
        <source>the compression of {part}</source>
        <translation>{part} 的压缩方式</translation>
    </message>
    <message>
        <source>the size of {part}</source>
        <translation>{part} 的大小</translation>
    </message>
    <message>
        <source>{cause} in line {line:0f} of {part}</source>
        <translation>{part} 第 {line:0f} 行：{cause}</translation>
    </message>
    <message>
        <source>XML: {reason}</source>
        <translation>XML：{reason}</translation>
    </message>
    <message>
        <source>too deeply nested XML</source>
        <translation>XML 嵌套过深</translation>
    </message>
    <message>
        <source>a document type declaration</source>
        <translation>含有文档类型声明</translation>
    </message>
    <message>
        <source>a tag of more than a megabyte</source>
        <translation>标记超过 1 兆字节</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>列表</translation>
    </message>
    <message>
        <source>it has no field '{field}'.</source>
        <translation>它没有字段“{field}”。</translation>
    </message>
    <message>
        <source>this version does not know its field '{field}'.</source>
        <translation>此版本不认识其字段“{field}”。</translation>
    </message>
    <message>
        <source>its field '{field}' is not a JSON object.</source>
        <translation>其字段“{field}”不是 JSON 对象。</translation>
    </message>
    <message>
        <source>its field '{field}' is not a list.</source>
        <translation>其字段“{field}”不是列表。</translation>
    </message>
    <message>
        <source>its field '{field}' must have {needed:0f} entries; it has {count:0f}.</source>
        <translation>其字段“{field}”必须有 {needed:0f} 项，而实际有 {count:0f} 项。</translation>
    </message>
    <message>
        <source>its field '{field}' is not a text.</source>
        <translation>其字段“{field}”不是文本。</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, neither true nor false.</source>
        <translation>其字段“{field}”是 {value}，既不是 true 也不是 false。</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, not a number.</source>
        <translation>其字段“{field}”是 {value}，不是数。</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, not a whole number in range.</source>
        <translation>其字段“{field}”是 {value}，不是允许范围内的整数。</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, and must be at least {least}.</source>
        <translation>其字段“{field}”是 {value}，而至少应为 {least}。</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, and must be above {least}.</source>
        <translation>其字段“{field}”是 {value}，而必须大于 {least}。</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, and must be from {least:0f} to {most:0f}.</source>
        <translation>其字段“{field}”是 {value}，而必须在 {least:0f} 到 {most:0f} 之间。</translation>
    </message>
    <message>
        <source>its field '{field}' is '{value}', a word that this version does not know.</source>
        <translation>其字段“{field}”是“{value}”，此版本不认识这个词。</translation>
    </message>
    <message>
        <source>its field '{field}' is empty.</source>
        <translation>其字段“{field}”为空。</translation>
    </message>
    <message>
        <source>its field '{field}' is no range: its lower end is above its upper end.</source>
        <translation>其字段“{field}”不是范围：下限高于上限。</translation>
    </message>
    <message>
        <source>its field '{field}' is not above that of the entry before it.</source>
        <translation>其字段“{field}”不大于前一项的值。</translation>
    </message>
    <message>
        <source>its field '{field}' is 0, which is no label.</source>
        <translation>其字段“{field}”是 0，不是标签。</translation>
    </message>
    <message>
        <source>its field '{field}' is a vector of no length.</source>
        <translation>其字段“{field}”是长度为零的向量。</translation>
    </message>
    <message>
        <source>its field '{field}' cannot name an object: a name has 1 to {most:0f} characters, no control characters and none of {separators}.</source>
        <translation>其字段“{field}”不能作为目标的名称：名称有 1 到 {most:0f} 个字符，不含控制字符，也不含 {separators} 中的任何字符。</translation>
    </message>
    <message>
        <source>its field '{field}' has a code that is empty, too long, or holds what separates codes.</source>
        <translation>其字段“{field}”含有空的、过长的或带有分隔符的代码。</translation>
    </message>
    <message>
        <source>its field '{field}' is a name that cannot be written into files.</source>
        <translation>其字段“{field}”是无法写入文件的名称。</translation>
    </message>
    <message>
        <source>it holds a number that is too large.</source>
        <translation>其中有一个过大的数。</translation>
    </message>
    <message>
        <source>several objects cannot be carried over time.</source>
        <translation>多个目标不能随时间传递。</translation>
    </message>
    <message>
        <source>a corrected frame begins with the surface of the frame beside it, not with that of a file.</source>
        <translation>校正过的帧从相邻帧的表面开始，而不是从文件的表面开始。</translation>
    </message>
    <message>
        <source>{file} holds {objects:0f} objects, where one is needed; handlebody-cli replay makes them all.</source>
        <translation>{file} 含有 {objects:0f} 个目标，而这里需要一个；handlebody-cli replay 可生成全部目标。</translation>
    </message>
    <message>
        <source>{file} is not needed: the session has no walls of a label map.</source>
        <translation>不需要 {file}：会话没有来自标签图的屏障。</translation>
    </message>
    <message>
        <source>{file} is not needed: nothing in the session begins with a surface.</source>
        <translation>不需要 {file}：会话中没有从表面开始的目标。</translation>
    </message>
    <message>
        <source>{file}: the session does not keep which file is meant, so that only one can be; {other} is given, too.</source>
        <translation>{file}：会话没有记录所指的是哪个文件，因此只能给出一个；但还给出了 {other}。</translation>
    </message>
    <message>
        <source>{file}: a series is chosen in DICOM alone, this is {format}.</source>
        <translation>{file}：只有 DICOM 才能选择序列，而这是 {format}。</translation>
    </message>
    <message>
        <source>{file}: a spacing is not above 0.</source>
        <translation>{file}：有一个间距不大于 0。</translation>
    </message>
    <message>
        <source>{file}: meshes are written as .stl, .vtp, .ply or .obj.</source>
        <translation>{file}：网格写为 .stl、.vtp、.ply 或 .obj。</translation>
    </message>
    <message>
        <source>{file}: a mesh with values is written as .vtp.</source>
        <translation>{file}：带数值的网格写为 .vtp。</translation>
    </message>
    <message>
        <source>{file}: volumes are written as .nii.gz, .nii, .nrrd or .mha.</source>
        <translation>{file}：体数据写为 .nii.gz、.nii、.nrrd 或 .mha。</translation>
    </message>
    <message>
        <source>{file}: 4D volumes are written as .nii.gz, .nii or .nrrd.</source>
        <translation>{file}：4D 体数据写为 .nii.gz、.nii 或 .nrrd。</translation>
    </message>
    <message>
        <source>a volume to be written needs at least two voxels along each axis</source>
        <translation>要写入的体数据沿每个轴至少需要两个体素</translation>
    </message>
    <message>
        <source>VTK wrote no scene of it</source>
        <translation>VTK 没有写出场景</translation>
    </message>
    <message>
        <source>no folder for temporary files can be made: {cause}.</source>
        <translation>无法创建临时文件夹：{cause}。</translation>
    </message>
    <message>
        <source>what the clicks mean there agrees to {percent:0f} % (Dice) with the object of frame {from_frame} as the images move it; the latter was taken</source>
        <translation>那里点击所指的目标与随图像移动的第 {from_frame} 帧目标吻合 {percent:0f} %（Dice）；已采用后者</translation>
    </message>
    <message>
        <source>what the clicks mean there fails ({cause}); the object of frame {from_frame} as the images move it was taken</source>
        <translation>那里点击所指的目标失败（{cause}）；已采用随图像移动的第 {from_frame} 帧目标</translation>
    </message>
    <message>
        <source>it was carried from frame {from_frame}, whose surface failed</source>
        <translation>该曲面自第 {from_frame} 帧传递而来，而那一帧的曲面已失败</translation>
    </message>
    <message>
        <source>{file} cannot be used as walls: it has {frames:0f} time points, and walls are the same at all of them.</source>
        <translation>{file} 不能用作屏障：它有 {frames:0f} 个时间点，而屏障在所有时间点都相同。</translation>
    </message>
    <message>
        <source>There are {frames:0f} time points; the first one is used.</source>
        <translation>共有 {frames:0f} 个时间点；使用第一个。</translation>
    </message>
    <message>
        <source>The header does not say where the first voxel lies; it is taken to lie at 0, 0, 0.</source>
        <translation>文件头没有说明第一个体素的位置；假定为 0, 0, 0。</translation>
    </message>
    <message>
        <source>{object} has parts that lie where they bound nothing, as one does that is inside out: it has no volume, and there is no Dice coefficient.</source>
        <translation>{object} 有部分位于不界定任何区域之处，例如内外翻转的部分：没有体积，也没有 Dice 系数。</translation>
    </message>
    <message>
        <source>The header does not state the distance of the slices: {spacing_mm:4g} mm are taken, the least between its frames, though a slice is {thickness_mm:4g} mm thick. Slices may be left out.</source>
        <translation>文件头未说明切面间距：采用其帧之间的最小距离 {spacing_mm:4g} mm，而切面厚度为 {thickness_mm:4g} mm。可能省略了部分切面。</translation>
    </message>
    <message>
        <source>the veto of iteration {iteration:0f} forbids nothing: the mesh is that of iteration {mesh_iteration:0f}</source>
        <translation>第 {iteration:0f} 次迭代的否决未起作用：网格取自第 {mesh_iteration:0f} 次迭代</translation>
    </message>
    <message>
        <source>the edit of iteration {iteration:0f} is not made: the mesh is that of iteration {mesh_iteration:0f}</source>
        <translation>第 {iteration:0f} 次迭代的编辑未执行：网格取自第 {mesh_iteration:0f} 次迭代</translation>
    </message>
    <message>
        <source>The volume of the surface, {volume_ml:4g} ml, lies outside of those of all runs with clicks, smoothing and noise a little different, {least_ml:4g} to {most_ml:4g} ml: they may have found another object</source>
        <translation>表面的体积 {volume_ml:4g} ml 在点击、平滑和噪声略有不同的所有运行的体积（{least_ml:4g} 至 {most_ml:4g} ml）之外：它们可能找到了另一个对象</translation>
    </message>
    <message>
        <source>The sensitivity cannot be told of a surface that was given as it is: there is no growth to repeat.</source>
        <translation>按原样给出的表面无法给出敏感性：没有可以重复的生长。</translation>
    </message>
    <message>
        <source>the clicks may mean fewer objects than {asked:0f}, which is the one that was asked for: number {taken:0f}, the last of them, was taken</source>
        <translation>点击可能表示的对象少于所要求的第 {asked:0f} 个：已采用其中最后一个，即第 {taken:0f} 个</translation>
    </message>
    <message>
        <source>The mesh encloses {mesh_ml:4g} ml, the voxels that it was made of {voxels_ml:4g} ml ({percent:0f} %): they are too few, or too narrow, for their shape to be kept.</source>
        <translation>网格包围 {mesh_ml:4g} ml，而生成它的体素为 {voxels_ml:4g} ml（{percent:0f} %）：体素太少或太窄，无法保持形状。</translation>
    </message>
    <message>
        <source>The edges of the mesh are {median_mm:3g} mm long in the median, not {asked_mm:4g} mm as was asked for: with such edges it would leave the voxels or intersect itself.</source>
        <translation>网格边长的中位数为 {median_mm:3g} mm，而不是所要求的 {asked_mm:4g} mm：用这样的边，网格会偏离体素或自相交。</translation>
    </message>
    <message>
        <source>the surface reaches {distance_mm:1f} mm into the ball of {radius_mm:1f} mm around the click outside of the object at {place:1f} mm: the image or other clicks speak against it</source>
        <translation>表面伸入位于 {place:1f} mm 的外部点周围半径 {radius_mm:1f} mm 的球内 {distance_mm:1f} mm：图像或其他点击与之相悖</translation>
    </message>
    <message>
        <source>The seed at {place:1f} mm lies in the ball of {radius_mm:1f} mm around the click outside of the object at {outside:1f} mm: they contradict each other.</source>
        <translation>位于 {place:1f} mm 的种子点在位于 {outside:1f} mm 的外部点周围半径 {radius_mm:1f} mm 的球内：两者相互矛盾。</translation>
    </message>
    <message>
        <source>The click outside of the object at {outside:1f} mm holds the deepest place of the surface to begin with, which stands for the object: give a seed, or another surface.</source>
        <translation>位于 {outside:1f} mm 的外部点包含起始表面的最深处，而该处代表对象：请给出种子点或另一个表面。</translation>
    </message>
    <message>
        <source>has no effect on an object that was given: its surface stays as it is, and nothing grows.</source>
        <translation>对给定的对象不起作用：其表面保持原样，不会生长。</translation>
    </message>
    <message>
        <source>has no effect with a range, by which the intensities alone say what the object is: leave one of them out.</source>
        <translation>与范围同用时不起作用：此时仅由强度决定对象；请去掉其中之一。</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies over the surface that was given, or within it, and that surface stays as it is.</source>
        <translation>位于 {place} mm 的壁与给定的表面重叠或在其内，而该表面保持原样。</translation>
    </message>
    <message>
        <source>object '{object}' has no seed and is left out.</source>
        <translation>对象“{object}”没有种子点，已略去。</translation>
    </message>
    <message>
        <source>{session} was made by version {version}; this is {here}, and the mesh may differ.</source>
        <translation>{session} 由版本 {version} 创建；当前版本为 {here}，网格可能不同。</translation>
    </message>
    <message>
        <source>the session carries the surface through other frames, too, and these figures are of frame {frame:0f} alone; handlebody-cli replay writes those of all.</source>
        <translation>该会话还将表面传递到其他帧，这些数值仅属于第 {frame:0f} 帧；handlebody-cli replay 会写出所有帧的数值。</translation>
    </message>
    <message>
        <source>has no effect: it says how a label becomes a surface, and {file} is a mesh.</source>
        <translation>不起作用：它说明标签如何变成表面，而 {file} 是网格。</translation>
    </message>
    <message>
        <source>{file} has {count:0f} components, and is to have no more than {most:0f}.</source>
        <translation>{file} 有 {count:0f} 个连通分量，但不得多于 {most:0f} 个。</translation>
    </message>
    <message>
        <source>{file} has {count:0f} handles or tunnels, and is to have no more than {most:0f}.</source>
        <translation>{file} 有 {count:0f} 个柄或隧道，但不得多于 {most:0f} 个。</translation>
    </message>
</context>
<context>
    <name>Sentences</name>
    <message>
        <source> More in the step Open.</source>
        <translation> 更多信息见“打开”步骤。</translation>
    </message>
</context>
<context>
    <name>SliceView</name>
    <message>
        <source>Axial</source>
        <translation>轴位</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>冠状位</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>矢状位</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>SurfaceView</name>
    <message>
        <source>%1 mm or more</source>
        <translation>%1 mm 或以上</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>outside: %1</source>
        <translation>外侧：%1</translation>
    </message>
    <message>
        <source>inside: %1</source>
        <translation>内侧：%1</translation>
    </message>
    <message>
        <source>on the reference: 0 mm</source>
        <translation>在参考上：0 mm</translation>
    </message>
</context>
<context>
    <name>handlebody::app::Screenshot</name>
    <message>
        <source>There is no seed to grow from: open a session.</source>
        <translation>没有可供生长的种子点：请打开会话。</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>无法写入 %1。</translation>
    </message>
    <message>
        <source>There is no event at iteration %1, and so no stage of it.</source>
        <translation>第 %1 次迭代没有事件，因此也没有其阶段。</translation>
    </message>
</context>
<context>
    <name>handlebody::ui</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>内存不足。</translation>
    </message>
    <message>
        <source>Something went wrong that has no name.</source>
        <translation>发生了未知错误。</translation>
    </message>
    <message>
        <source>There is no surface yet: grow one first.</source>
        <translation>还没有表面：请先生长一个。</translation>
    </message>
    <message>
        <source>There is no centre line in “%1”: %2.</source>
        <translation>“%1”中没有中心线：%2。</translation>
    </message>
    <message>
        <source>The first place lies in none of the objects.</source>
        <translation>第一个位置不在任何目标内。</translation>
    </message>
    <message>
        <source>Slice %1 of %2</source>
        <translation>第 %1 层，共 %2 层</translation>
    </message>
    <message>
        <source>%1  %2  %3 mm</source>
        <translation>%1  %2  %3 mm</translation>
    </message>
    <message>
        <source>%1, %2 mm</source>
        <translation>%1, %2 mm</translation>
    </message>
    <message>
        <source>less than 1 %</source>
        <translation>小于 1 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>not compared with the image</source>
        <translation>未与图像比较</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>未比较</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>移动中</translation>
    </message>
    <message>
        <source>settled</source>
        <translation>已静止</translation>
    </message>
    <message>
        <source>new handle</source>
        <translation>新环柄</translation>
    </message>
    <message>
        <source>colliding</source>
        <translation>碰撞</translation>
    </message>
    <message>
        <source>no edge in the image: %1 of the surface</source>
        <translation>图像无边缘：占表面 %1</translation>
    </message>
    <message>
        <source>edge in the image</source>
        <translation>图像有边缘</translation>
    </message>
    <message>
        <source>no edge: %1</source>
        <translation>无边缘：%1</translation>
    </message>
    <message>
        <source>border of the volume</source>
        <translation>体数据边界</translation>
    </message>
    <message>
        <source>pinned</source>
        <translation>已固定</translation>
    </message>
    <message>
        <source>colliding triangles</source>
        <translation>碰撞三角形</translation>
    </message>
    <message>
        <source>vertices that are taken out</source>
        <translation>移除的顶点</translation>
    </message>
    <message>
        <source>boundary polygons</source>
        <translation>边界多边形</translation>
    </message>
    <message>
        <source>handle</source>
        <translation>环柄</translation>
    </message>
    <message>
        <source>closed mesh</source>
        <translation>闭合网格</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>画笔半径</translation>
    </message>
    <message>
        <source>The brush is a ball, the same for walls and for the surface; Ctrl+wheel changes it while it is on</source>
        <translation>画笔是球形，屏障和表面共用；启用时用 Ctrl+滚轮改变大小</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Open file…</source>
        <translation>打开文件(&amp;O)…</translation>
    </message>
    <message>
        <source>Open &amp;folder…</source>
        <translation>打开文件夹(&amp;F)…</translation>
    </message>
    <message>
        <source>Open a folder with a DICOM series</source>
        <translation>打开含 DICOM 序列的文件夹</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>保存会话(&amp;S)</translation>
    </message>
    <message>
        <source>Save volume reference, seeds and parameters, to go on later or to replay</source>
        <translation>保存体数据引用、种子点和参数，以便以后继续或重放</translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation>会话另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Save the session under another name</source>
        <translation>以其他名称保存会话</translation>
    </message>
    <message>
        <source>&amp;Export result…</source>
        <translation>导出结果(&amp;E)…</translation>
    </message>
    <message>
        <source>Write the surface or its label map to a file</source>
        <translation>将表面或其标签图写入文件</translation>
    </message>
    <message>
        <source>Export repor&amp;t…</source>
        <translation>导出报告(&amp;T)…</translation>
    </message>
    <message>
        <source>Write parameters, numbers and events as JSON</source>
        <translation>将参数、数值和事件写为 JSON</translation>
    </message>
    <message>
        <source>Export &amp;picture…</source>
        <translation>导出图片(&amp;P)…</translation>
    </message>
    <message>
        <source>Write what the views show as PNG</source>
        <translation>将视图内容写为 PNG</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Close the program</source>
        <translation>关闭程序</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>撤销上一次更改</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Do again what was taken back</source>
        <translation>恢复被撤销的更改</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Layout</source>
        <translation>布局(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>步骤(&amp;S)</translation>
    </message>
    <message>
        <source>3D &amp;camera</source>
        <translation>3D 相机(&amp;C)</translation>
    </message>
    <message>
        <source>All &amp;four</source>
        <translation>全部四个(&amp;F)</translation>
    </message>
    <message>
        <source>Axial, 3D, coronal and sagittal view together</source>
        <translation>同时显示轴位、3D、冠状位和矢状位视图</translation>
    </message>
    <message>
        <source>&amp;Axial only</source>
        <translation>仅轴位(&amp;A)</translation>
    </message>
    <message>
        <source>Only the axial slice</source>
        <translation>仅显示轴位切面</translation>
    </message>
    <message>
        <source>&amp;Coronal only</source>
        <translation>仅冠状位(&amp;C)</translation>
    </message>
    <message>
        <source>Only the coronal slice</source>
        <translation>仅显示冠状位切面</translation>
    </message>
    <message>
        <source>&amp;Sagittal only</source>
        <translation>仅矢状位(&amp;S)</translation>
    </message>
    <message>
        <source>Only the sagittal slice</source>
        <translation>仅显示矢状位切面</translation>
    </message>
    <message>
        <source>&amp;3D only</source>
        <translation>仅 3D(&amp;3)</translation>
    </message>
    <message>
        <source>Only the surface in 3D</source>
        <translation>仅显示 3D 表面</translation>
    </message>
    <message>
        <source>1 &amp;Open</source>
        <translation>&amp;1 打开</translation>
    </message>
    <message>
        <source>Choose a volume</source>
        <translation>选择体数据</translation>
    </message>
    <message>
        <source>2 &amp;Seed</source>
        <translation>&amp;2 种子点</translation>
    </message>
    <message>
        <source>Place seeds in the object</source>
        <translation>在目标内放置种子点</translation>
    </message>
    <message>
        <source>3 &amp;Tune</source>
        <translation>&amp;3 调整</translation>
    </message>
    <message>
        <source>Set range and forces</source>
        <translation>设置范围和力</translation>
    </message>
    <message>
        <source>4 &amp;Grow</source>
        <translation>&amp;4 生长</translation>
    </message>
    <message>
        <source>Grow the surface and watch it</source>
        <translation>使表面生长并观察</translation>
    </message>
    <message>
        <source>5 &amp;Correct</source>
        <translation>&amp;5 修正</translation>
    </message>
    <message>
        <source>Walls, and what is held back: mend what has grown wrong</source>
        <translation>屏障与被阻止的变化：修正生长错误之处</translation>
    </message>
    <message>
        <source>6 &amp;Export</source>
        <translation>&amp;6 导出</translation>
    </message>
    <message>
        <source>Write the results</source>
        <translation>写出结果</translation>
    </message>
    <message>
        <source>&amp;Reset views</source>
        <translation>重置视图(&amp;R)</translation>
    </message>
    <message>
        <source>Whole slices, camera from the front</source>
        <translation>完整切面，相机正面</translation>
    </message>
    <message>
        <source>From &amp;above (superior)</source>
        <translation>从上方（头侧）(&amp;A)</translation>
    </message>
    <message>
        <source>3D view: look from superior; with the 3D view in focus</source>
        <translation>3D 视图：从头侧观察；需 3D 视图获得焦点</translation>
    </message>
    <message>
        <source>From the &amp;front (anterior)</source>
        <translation>从前方（腹侧）(&amp;F)</translation>
    </message>
    <message>
        <source>3D view: look from anterior; with the 3D view in focus</source>
        <translation>3D 视图：从前方观察；需 3D 视图获得焦点</translation>
    </message>
    <message>
        <source>From the &amp;left</source>
        <translation>从左侧(&amp;L)</translation>
    </message>
    <message>
        <source>3D view: look from the patient's left; with the 3D view in focus</source>
        <translation>3D 视图：从患者左侧观察；需 3D 视图获得焦点</translation>
    </message>
    <message>
        <source>Slices &amp;in 3D</source>
        <translation>3D 中显示切面(&amp;I)</translation>
    </message>
    <message>
        <source>Show the three slices in the 3D view</source>
        <translation>在 3D 视图中显示三个切面</translation>
    </message>
    <message>
        <source>Walls a&amp;nd pins</source>
        <translation>屏障与固定(&amp;N)</translation>
    </message>
    <message>
        <source>Draw the active object's walls, and what of its surface is pinned</source>
        <translation>绘制当前目标的屏障及其表面的固定部分</translation>
    </message>
    <message>
        <source>CT pr&amp;esets</source>
        <translation>CT 预设(&amp;E)</translation>
    </message>
    <message>
        <source>C&amp;olour map</source>
        <translation>颜色映射(&amp;O)</translation>
    </message>
    <message>
        <source>Sur&amp;face</source>
        <translation>表面(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>外观(&amp;A)</translation>
    </message>
    <message>
        <source>Langua&amp;ge</source>
        <translation>语言(&amp;G)</translation>
    </message>
    <message>
        <source>Language of the texts and numbers in the window, from the next start on</source>
        <translation>窗口文字和数字的语言，下次启动时生效</translation>
    </message>
    <message>
        <source>&amp;Window and level by dragging</source>
        <translation>拖动调节窗宽窗位(&amp;W)</translation>
    </message>
    <message>
        <source>Drag in a slice: sideways for the window (contrast), up and down for the level (brightness)</source>
        <translation>在切面中拖动：左右调节窗宽（对比度），上下调节窗位（亮度）</translation>
    </message>
    <message>
        <source>Au&amp;to window</source>
        <translation>自动窗宽窗位(&amp;T)</translation>
    </message>
    <message>
        <source>Window and level from the intensities of the volume</source>
        <translation>根据体数据强度设定窗宽窗位</translation>
    </message>
    <message>
        <source>&amp;Soft tissue (400 / 40 HU)</source>
        <translation>软组织 (400 / 40 HU)(&amp;S)</translation>
    </message>
    <message>
        <source>Window 400, level 40</source>
        <translation>窗宽 400，窗位 40</translation>
    </message>
    <message>
        <source>&amp;Lung (1500 / −600 HU)</source>
        <translation>肺 (1500 / −600 HU)(&amp;L)</translation>
    </message>
    <message>
        <source>Window 1500, level −600</source>
        <translation>窗宽 1500，窗位 −600</translation>
    </message>
    <message>
        <source>&amp;Bone (1800 / 400 HU)</source>
        <translation>骨 (1800 / 400 HU)(&amp;B)</translation>
    </message>
    <message>
        <source>Window 1800, level 400</source>
        <translation>窗宽 1800，窗位 400</translation>
    </message>
    <message>
        <source>B&amp;rain (80 / 40 HU)</source>
        <translation>脑 (80 / 40 HU)(&amp;R)</translation>
    </message>
    <message>
        <source>Window 80, level 40</source>
        <translation>窗宽 80，窗位 40</translation>
    </message>
    <message>
        <source>&amp;Vessels (600 / 170 HU)</source>
        <translation>血管 (600 / 170 HU)(&amp;V)</translation>
    </message>
    <message>
        <source>Window 600, level 170</source>
        <translation>窗宽 600，窗位 170</translation>
    </message>
    <message>
        <source>&amp;Grey</source>
        <translation>灰度(&amp;G)</translation>
    </message>
    <message>
        <source>Black to white</source>
        <translation>从黑到白</translation>
    </message>
    <message>
        <source>&amp;Inverted</source>
        <translation>反转(&amp;I)</translation>
    </message>
    <message>
        <source>White to black</source>
        <translation>从白到黑</translation>
    </message>
    <message>
        <source>&amp;Hot</source>
        <translation>热色(&amp;H)</translation>
    </message>
    <message>
        <source>Black over red and yellow to white</source>
        <translation>由黑经红、黄到白</translation>
    </message>
    <message>
        <source>&amp;Contrast-enhancing</source>
        <translation>对比增强(&amp;C)</translation>
    </message>
    <message>
        <source>Dark intensities spread over many colours, for ultrasound</source>
        <translation>将暗强度展开为多种颜色，用于超声</translation>
    </message>
    <message>
        <source>&amp;Plain</source>
        <translation>普通(&amp;P)</translation>
    </message>
    <message>
        <source>One colour, shaded</source>
        <translation>单色着色</translation>
    </message>
    <message>
        <source>With &amp;edges</source>
        <translation>显示边(&amp;E)</translation>
    </message>
    <message>
        <source>The triangles' edges are drawn</source>
        <translation>绘制三角形的边</translation>
    </message>
    <message>
        <source>By &amp;state</source>
        <translation>按状态(&amp;S)</translation>
    </message>
    <message>
        <source>Moving, settled, new handle and colliding faces in their colours</source>
        <translation>以不同颜色显示移动、静止、新环柄和碰撞的面</translation>
    </message>
    <message>
        <source>Support by the &amp;image</source>
        <translation>图像支持度(&amp;I)</translation>
    </message>
    <message>
        <source>Blue where the image shows no edge, in 3D and on the slices</source>
        <translation>在 3D 和切面中以蓝色显示图像无边缘处</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>跟随系统(&amp;S)</translation>
    </message>
    <message>
        <source>Light or dark as the desktop</source>
        <translation>明暗与桌面一致</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>Dark text on light ground</source>
        <translation>浅底深字</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>深色(&amp;D)</translation>
    </message>
    <message>
        <source>Light text on dark ground</source>
        <translation>深底浅字</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>全屏(&amp;U)</translation>
    </message>
    <message>
        <source>The window fills the screen</source>
        <translation>窗口铺满屏幕</translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation>种子点(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Add at the crosshair</source>
        <translation>在十字线处添加(&amp;A)</translation>
    </message>
    <message>
        <source>Place a seed where the crosshair is</source>
        <translation>在十字线处放置种子点</translation>
    </message>
    <message>
        <source>Add &amp;outside of the object</source>
        <translation>在目标外添加(&amp;O)</translation>
    </message>
    <message>
        <source>Place a click outside of the object where the crosshair is</source>
        <translation>在十字线处放置外部点</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>Delete the selected seed or click outside</source>
        <translation>删除所选种子点或外部点</translation>
    </message>
    <message>
        <source>&amp;Larger radius</source>
        <translation>增大半径(&amp;L)</translation>
    </message>
    <message>
        <source>Radius of the selected seed half a voxel larger</source>
        <translation>所选种子点半径增大半个体素</translation>
    </message>
    <message>
        <source>&amp;Smaller radius</source>
        <translation>减小半径(&amp;S)</translation>
    </message>
    <message>
        <source>Radius of the selected seed half a voxel smaller</source>
        <translation>所选种子点半径减小半个体素</translation>
    </message>
    <message>
        <source>Select the &amp;next</source>
        <translation>选择下一个(&amp;N)</translation>
    </message>
    <message>
        <source>Select the next seed and move the crosshair there</source>
        <translation>选择下一个种子点并将十字线移到那里</translation>
    </message>
    <message>
        <source>S&amp;maller object</source>
        <translation>更小的目标(&amp;M)</translation>
    </message>
    <message>
        <source>Take the next smaller of the objects that the clicks may mean</source>
        <translation>选取可能目标中较小的下一个</translation>
    </message>
    <message>
        <source>La&amp;rger object</source>
        <translation>更大的目标(&amp;R)</translation>
    </message>
    <message>
        <source>Take the next larger of the objects that the clicks may mean</source>
        <translation>选取可能目标中较大的下一个</translation>
    </message>
    <message>
        <source>&amp;Grow</source>
        <translation>生长(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Grow the surface, or pause</source>
        <translation>使表面生长或暂停</translation>
    </message>
    <message>
        <source>One step &amp;forward</source>
        <translation>前进一步(&amp;F)</translation>
    </message>
    <message>
        <source>One iteration forward</source>
        <translation>前进一次迭代</translation>
    </message>
    <message>
        <source>One step &amp;back</source>
        <translation>后退一步(&amp;B)</translation>
    </message>
    <message>
        <source>One iteration back, exactly</source>
        <translation>精确后退一次迭代</translation>
    </message>
    <message>
        <source>&amp;Next event</source>
        <translation>下一事件(&amp;N)</translation>
    </message>
    <message>
        <source>To the next change of topology; grows until there is one</source>
        <translation>到下一次拓扑变化；生长直到出现</translation>
    </message>
    <message>
        <source>&amp;Previous event</source>
        <translation>上一事件(&amp;P)</translation>
    </message>
    <message>
        <source>To the previous change of topology</source>
        <translation>到上一次拓扑变化</translation>
    </message>
    <message>
        <source>Back to the s&amp;tart</source>
        <translation>回到起点(&amp;T)</translation>
    </message>
    <message>
        <source>To the seed spheres</source>
        <translation>回到种子球</translation>
    </message>
    <message>
        <source>To the &amp;last step</source>
        <translation>到最后一步(&amp;L)</translation>
    </message>
    <message>
        <source>To the last iteration that was worked out</source>
        <translation>到已计算的最后一次迭代</translation>
    </message>
    <message>
        <source>&amp;Correct</source>
        <translation>修正(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paint walls</source>
        <translation>绘制屏障(&amp;P)</translation>
    </message>
    <message>
        <source>Drag in a slice: the surface may not go where it is painted</source>
        <translation>在切面中拖动：表面不得进入所绘区域</translation>
    </message>
    <message>
        <source>&amp;Erase walls</source>
        <translation>擦除屏障(&amp;E)</translation>
    </message>
    <message>
        <source>Drag in a slice: what the eraser touches is no wall any more</source>
        <translation>在切面中拖动：被擦到的不再是屏障</translation>
    </message>
    <message>
        <source>&amp;Larger brush</source>
        <translation>增大画笔(&amp;L)</translation>
    </message>
    <message>
        <source>Radius of the brush a tenth larger</source>
        <translation>画笔半径增大十分之一</translation>
    </message>
    <message>
        <source>S&amp;maller brush</source>
        <translation>减小画笔(&amp;M)</translation>
    </message>
    <message>
        <source>Radius of the brush a tenth smaller</source>
        <translation>画笔半径减小十分之一</translation>
    </message>
    <message>
        <source>&amp;Wall at the crosshair</source>
        <translation>在十字线处设屏障(&amp;W)</translation>
    </message>
    <message>
        <source>A wall as large as the brush where the crosshair is</source>
        <translation>在十字线处设置画笔大小的屏障</translation>
    </message>
    <message>
        <source>E&amp;rase at the crosshair</source>
        <translation>在十字线处擦除(&amp;R)</translation>
    </message>
    <message>
        <source>No walls where the eraser would touch them at the crosshair</source>
        <translation>擦除十字线处橡皮触及的屏障</translation>
    </message>
    <message>
        <source>Go &amp;on from before the walls</source>
        <translation>从屏障之前继续(&amp;O)</translation>
    </message>
    <message>
        <source>Back to before the surface came to the new walls, and on from there</source>
        <translation>退回到表面到达新屏障之前并由此继续</translation>
    </message>
    <message>
        <source>Remo&amp;ve all walls</source>
        <translation>移除所有屏障(&amp;V)</translation>
    </message>
    <message>
        <source>Nothing that was painted is a wall any more</source>
        <translation>所绘内容不再是屏障</translation>
    </message>
    <message>
        <source>Pin &amp;by brush</source>
        <translation>用画笔固定(&amp;B)</translation>
    </message>
    <message>
        <source>Drag over the surface, in a slice or in 3D: what the brush covers stays as it is from the shown iteration on</source>
        <translation>在切面或 3D 中沿表面拖动：画笔覆盖的部分从所示迭代起保持不变</translation>
    </message>
    <message>
        <source>Unp&amp;in by brush</source>
        <translation>用画笔取消固定(&amp;I)</translation>
    </message>
    <message>
        <source>Drag over the surface, in a slice or in 3D: pins that the brush touches hold no more</source>
        <translation>在切面或 3D 中沿表面拖动：画笔触及的固定失效</translation>
    </message>
    <message>
        <source>Smoot&amp;h by brush</source>
        <translation>用画笔平滑(&amp;H)</translation>
    </message>
    <message>
        <source>Click on the surface, in a slice or in 3D: it is smoothed under the brush, as the next step</source>
        <translation>在切面或 3D 中点击表面：画笔下的部分被平滑，作为下一步</translation>
    </message>
    <message>
        <source>Pull by &amp;dragging</source>
        <translation>拖动拉伸(&amp;D)</translation>
    </message>
    <message>
        <source>Drag a point of the surface, in a slice or in 3D: it goes there, and what lies within the brush's radius less and less, as the next step</source>
        <translation>在切面或 3D 中拖动表面一点：该点移到那里，画笔半径内的部分随之递减移动，作为下一步</translation>
    </message>
    <message>
        <source>Cut alon&amp;g a line</source>
        <translation>沿线切割(&amp;G)</translation>
    </message>
    <message>
        <source>Draw a line across the surface in a slice: it is cut there at right angles to the slice, and closed on both sides, as the next step</source>
        <translation>在切面中横过表面画线：在该处垂直于切面切开并封闭两侧，作为下一步</translation>
    </message>
    <message>
        <source>Remove &amp;all pins</source>
        <translation>移除所有固定(&amp;A)</translation>
    </message>
    <message>
        <source>Nothing of the surface is pinned any more</source>
        <translation>表面不再有固定部分</translation>
    </message>
    <message>
        <source>Pi&amp;n here</source>
        <translation>在此固定(&amp;N)</translation>
    </message>
    <message>
        <source>The surface around the crosshair stays as it is from the shown iteration on</source>
        <translation>十字线周围的表面从所示迭代起保持不变</translation>
    </message>
    <message>
        <source>&amp;Smooth here</source>
        <translation>在此平滑(&amp;S)</translation>
    </message>
    <message>
        <source>Smooth the surface around its point nearest to the crosshair, as the next step</source>
        <translation>平滑表面上离十字线最近点的周围，作为下一步</translation>
    </message>
    <message>
        <source>P&amp;ull here</source>
        <translation>拉到此处(&amp;U)</translation>
    </message>
    <message>
        <source>Pull the point of the surface nearest to the crosshair there, as the next step</source>
        <translation>将表面上离十字线最近的点拉到那里，作为下一步</translation>
    </message>
    <message>
        <source>&amp;Cut here</source>
        <translation>在此切割(&amp;C)</translation>
    </message>
    <message>
        <source>Cut along the chosen plane through the crosshair, as the next step</source>
        <translation>沿经过十字线的所选平面切割，作为下一步</translation>
    </message>
    <message>
        <source>&amp;Objects</source>
        <translation>目标(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Add object</source>
        <translation>添加目标(&amp;A)</translation>
    </message>
    <message>
        <source>Another object in this volume; the surfaces before it are walls for it</source>
        <translation>在此体数据中另加目标；之前的表面对它是屏障</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>复制(&amp;D)</translation>
    </message>
    <message>
        <source>Another object with the same seeds and parameters</source>
        <translation>以相同种子点和参数另加目标</translation>
    </message>
    <message>
        <source>D&amp;elete object</source>
        <translation>删除目标(&amp;E)</translation>
    </message>
    <message>
        <source>Delete the active object with its seeds and surface</source>
        <translation>删除当前目标及其种子点和表面</translation>
    </message>
    <message>
        <source>&amp;Properties…</source>
        <translation>属性(&amp;P)…</translation>
    </message>
    <message>
        <source>Name, colour, label value and term of the active object</source>
        <translation>当前目标的名称、颜色、标签值和术语</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>上移(&amp;U)</translation>
    </message>
    <message>
        <source>The active object earlier in the list: what two claim belongs to the first</source>
        <translation>将当前目标前移：重叠部分归排在前面者</translation>
    </message>
    <message>
        <source>Move do&amp;wn</source>
        <translation>下移(&amp;W)</translation>
    </message>
    <message>
        <source>The active object later in the list</source>
        <translation>将当前目标后移：重叠部分归排在前面者</translation>
    </message>
    <message>
        <source>&amp;Next object</source>
        <translation>下一目标(&amp;N)</translation>
    </message>
    <message>
        <source>The next object of the list is active</source>
        <translation>激活列表中的下一个目标</translation>
    </message>
    <message>
        <source>P&amp;revious object</source>
        <translation>上一目标(&amp;R)</translation>
    </message>
    <message>
        <source>The object before it in the list is active</source>
        <translation>激活列表中的上一个目标</translation>
    </message>
    <message>
        <source>&amp;Visible</source>
        <translation>可见(&amp;V)</translation>
    </message>
    <message>
        <source>Draw the surface of the active object</source>
        <translation>绘制当前目标的表面</translation>
    </message>
    <message>
        <source>&amp;Locked</source>
        <translation>锁定(&amp;L)</translation>
    </message>
    <message>
        <source>Change nothing of the active object</source>
        <translation>不更改当前目标</translation>
    </message>
    <message>
        <source>&amp;Grow all</source>
        <translation>全部生长(&amp;G)</translation>
    </message>
    <message>
        <source>Grow all objects that are not done, in the order of the list</source>
        <translation>按列表顺序使所有未完成目标生长</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>测量(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Measures</source>
        <translation>测量值(&amp;M)</translation>
    </message>
    <message>
        <source>Volume, area, diameters, intensities and distances of the objects, as a table</source>
        <translation>以表格列出目标的体积、面积、直径、强度和距离</translation>
    </message>
    <message>
        <source>&amp;Ruler</source>
        <translation>标尺(&amp;R)</translation>
    </message>
    <message>
        <source>Click two points in the slices or on the surface: their distance in mm</source>
        <translation>在切面或表面上点击两点：其距离（mm）</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>角度(&amp;A)</translation>
    </message>
    <message>
        <source>Click three points, the second where the legs meet: the angle in degrees</source>
        <translation>点击三点，第二点为顶点：角度（度）</translation>
    </message>
    <message>
        <source>&amp;Centre line</source>
        <translation>中心线(&amp;C)</translation>
    </message>
    <message>
        <source>Click two places of an object: the line along its middle and the sections across it</source>
        <translation>点击目标的两处：沿其中部的线及横截面</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Guide</source>
        <translation>指南(&amp;G)</translation>
    </message>
    <message>
        <source>How to use the program</source>
        <translation>如何使用本程序</translation>
    </message>
    <message>
        <source>&amp;Keyboard and mouse</source>
        <translation>键盘和鼠标(&amp;K)</translation>
    </message>
    <message>
        <source>All keys and mouse buttons</source>
        <translation>所有按键和鼠标键</translation>
    </message>
    <message>
        <source>&amp;About Handlebody</source>
        <translation>关于 Handlebody(&amp;A)</translation>
    </message>
    <message>
        <source>Version, purpose, licences</source>
        <translation>版本、用途、许可证</translation>
    </message>
    <message>
        <source>Dice</source>
        <translation>Dice</translation>
    </message>
    <message>
        <source>IoU</source>
        <translation>IoU</translation>
    </message>
    <message>
        <source>Mean distance of the surfaces, ASSD (mm)</source>
        <translation>表面平均距离 ASSD (mm)</translation>
    </message>
    <message>
        <source>95 % Hausdorff distance (mm)</source>
        <translation>95 % Hausdorff 距离 (mm)</translation>
    </message>
    <message>
        <source>Hausdorff distance (mm)</source>
        <translation>Hausdorff 距离 (mm)</translation>
    </message>
    <message>
        <source>Volume (ml)</source>
        <translation>体积 (ml)</translation>
    </message>
    <message>
        <source>Volume, difference (ml)</source>
        <translation>体积差 (ml)</translation>
    </message>
    <message>
        <source>Area (cm²)</source>
        <translation>面积 (cm²)</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>连通分量</translation>
    </message>
    <message>
        <source>Tunnels</source>
        <translation>隧道</translation>
    </message>
    <message>
        <source>Cavities</source>
        <translation>空腔</translation>
    </message>
    <message>
        <source> or </source>
        <translation> 或 </translation>
    </message>
    <message>
        <source>Mouse and keys in a slice</source>
        <translation>切面中的鼠标和按键</translation>
    </message>
    <message>
        <source>Left click</source>
        <translation>左键单击</translation>
    </message>
    <message>
        <source>Crosshair</source>
        <translation>十字线</translation>
    </message>
    <message>
        <source>Return; with Shift</source>
        <translation>回车；加 Shift</translation>
    </message>
    <message>
        <source>Seed at the crosshair; click outside of the object</source>
        <translation>十字线处的种子点；外部点</translation>
    </message>
    <message>
        <source>Left drag on a seed, on its rim</source>
        <translation>左键拖动种子点、其边缘</translation>
    </message>
    <message>
        <source>Move it, change its radius</source>
        <translation>移动，改变半径</translation>
    </message>
    <message>
        <source>Wheel; with Shift</source>
        <translation>滚轮；加 Shift</translation>
    </message>
    <message>
        <source>Next slice; five slices</source>
        <translation>下一层；五层</translation>
    </message>
    <message>
        <source>Right drag, Ctrl+wheel</source>
        <translation>右键拖动，Ctrl+滚轮</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Middle drag, Shift+left drag</source>
        <translation>中键拖动，Shift+左键拖动</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>平移</translation>
    </message>
    <message>
        <source>Arrows; with Shift</source>
        <translation>方向键；加 Shift</translation>
    </message>
    <message>
        <source>Crosshair by one voxel; by five</source>
        <translation>十字线移动一个体素；五个</translation>
    </message>
    <message>
        <source>Page Up, Page Down</source>
        <translation>Page Up、Page Down</translation>
    </message>
    <message>
        <source>Next, previous slice</source>
        <translation>下一层、上一层</translation>
    </message>
    <message>
        <source>B or E, then left drag; Ctrl+wheel</source>
        <translation>B 或 E，再左键拖动；Ctrl+滚轮</translation>
    </message>
    <message>
        <source>Paint or erase walls; radius of the brush</source>
        <translation>绘制或擦除屏障；画笔半径</translation>
    </message>
    <message>
        <source>R, A or C, then clicks</source>
        <translation>R、A 或 C，再点击</translation>
    </message>
    <message>
        <source>Ruler, angle, centre line: place points; Return: at the crosshair</source>
        <translation>标尺、角度、中心线：放置点；回车：在十字线处</translation>
    </message>
    <message>
        <source>Left drag on the end of a ruler or an angle</source>
        <translation>左键拖动标尺或角度的端点</translation>
    </message>
    <message>
        <source>Move it</source>
        <translation>移动它</translation>
    </message>
    <message>
        <source>L or Shift+L, then left drag</source>
        <translation>L 或 Shift+L，再左键拖动</translation>
    </message>
    <message>
        <source>Pin or unpin the surface under the brush</source>
        <translation>固定或取消固定画笔下的表面</translation>
    </message>
    <message>
        <source>M, then left click</source>
        <translation>M，再左键单击</translation>
    </message>
    <message>
        <source>Smooth the surface under the brush</source>
        <translation>平滑画笔下的表面</translation>
    </message>
    <message>
        <source>U, then left drag from the outline</source>
        <translation>U，再从轮廓左键拖动</translation>
    </message>
    <message>
        <source>Pull the surface by that point</source>
        <translation>拉动表面上的该点</translation>
    </message>
    <message>
        <source>X, then left drag across the outline</source>
        <translation>X，再左键横过轮廓拖动</translation>
    </message>
    <message>
        <source>Cut the surface along that line</source>
        <translation>沿该线切割表面</translation>
    </message>
    <message>
        <source>W, then left drag</source>
        <translation>W，再左键拖动</translation>
    </message>
    <message>
        <source>Window (sideways) and level (up and down)</source>
        <translation>窗宽（左右）和窗位（上下）</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>双击</translation>
    </message>
    <message>
        <source>This view alone, or all four</source>
        <translation>仅此视图，或全部四个</translation>
    </message>
    <message>
        <source>Mouse in the 3D view</source>
        <translation>3D 视图中的鼠标</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>左键拖动</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>L, Shift+L, M or U, then left on the surface</source>
        <translation>L、Shift+L、M 或 U，再在表面上按左键</translation>
    </message>
    <message>
        <source>Pin, unpin, smooth, pull; beside it: rotate</source>
        <translation>固定、取消固定、平滑、拉动；在旁边：旋转</translation>
    </message>
    <message>
        <source>R, A or C, then clicks on the surface</source>
        <translation>R、A 或 C，再点击表面</translation>
    </message>
    <message>
        <source>Ruler, angle, centre line: place points</source>
        <translation>标尺、角度、中心线：放置点</translation>
    </message>
    <message>
        <source>Right drag, wheel</source>
        <translation>右键拖动，滚轮</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Close the message over the views; else give up a stroke or a point, put brush and ruler away, leave window and level</source>
        <translation>关闭视图上方的消息；否则放弃笔画或点，收起画笔和标尺，退出窗宽窗位</translation>
    </message>
    <message>
        <source>window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>3D view, mesh files, pictures</source>
        <translation>3D 视图、网格文件、图片</translation>
    </message>
    <message>
        <source>reading and writing volumes</source>
        <translation>读写体数据</translation>
    </message>
    <message>
        <source>linear algebra</source>
        <translation>线性代数</translation>
    </message>
    <message>
        <source>SHA-256 of volumes</source>
        <translation>体数据的 SHA-256</translation>
    </message>
    <message>
        <source>compressed files</source>
        <translation>压缩文件</translation>
    </message>
    <message>
        <source>sessions and reports</source>
        <translation>会话和报告</translation>
    </message>
    <message>
        <source>command line</source>
        <translation>命令行</translation>
    </message>
    <message>
        <source>Keyboard and mouse</source>
        <translation>键盘和鼠标</translation>
    </message>
    <message>
        <source>Grows a certified surface from a point in a medical volume; the surface may change its topology on the way.</source>
        <translation>从医学体数据中的一点生长出经认证的表面；其拓扑在过程中可以改变。</translation>
    </message>
    <message>
        <source>Apache License 2.0. The method is that of the paper “A Combinatorial Method for Topology Adaptations in 3D Deformable Models”.</source>
        <translation>Apache 许可证 2.0。方法出自论文“A Combinatorial Method for Topology Adaptations in 3D Deformable Models”。</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>程序库</translation>
    </message>
    <message>
        <source>Qt is linked dynamically and can be replaced by another version of it.</source>
        <translation>Qt 为动态链接，可替换为其他版本。</translation>
    </message>
    <message>
        <source>For research use only. Handlebody is not a medical device; do not use it for diagnosis or treatment.</source>
        <translation>仅供研究使用。Handlebody 不是医疗器械；请勿用于诊断或治疗。</translation>
    </message>
    <message>
        <source>they meet</source>
        <translation>相接触</translation>
    </message>
    <message>
        <source>%1, one within the other</source>
        <translation>%1，一个在另一个内</translation>
    </message>
    <message>
        <source>  from %1: mean %2, least %3, 95 % up to %4, largest %5</source>
        <translation>  从 %1：平均 %2，最小 %3，95 % 不超过 %4，最大 %5</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Volume
(ml)</source>
        <translation>体积
(ml)</translation>
    </message>
    <message>
        <source>Area
(cm²)</source>
        <translation>面积
(cm²)</translation>
    </message>
    <message>
        <source>Largest
Ø (mm)</source>
        <translation>最大
Ø (mm)</translation>
    </message>
    <message>
        <source>Intensity
mean ± SD</source>
        <translation>强度
均值 ± SD</translation>
    </message>
    <message>
        <source>Nearest object
(mm)</source>
        <translation>最近目标
(mm)</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Along its axes: %1 mm</source>
        <translation>沿自身轴：%1 mm</translation>
    </message>
    <message>
        <source>Along x, y, z: %1 mm</source>
        <translation>沿 x、y、z：%1 mm</translation>
    </message>
    <message>
        <source>Largest Ø from %1 to %2</source>
        <translation>最大 Ø 从 %1 到 %2</translation>
    </message>
    <message>
        <source>Centroid: %1 LPS</source>
        <translation>质心：%1 LPS</translation>
    </message>
    <message>
        <source>Intensity %1 to %2, %3 voxels</source>
        <translation>强度 %1 至 %2，%3 个体素</translation>
    </message>
    <message>
        <source>Components %1, cavities %2, tunnels %3</source>
        <translation>连通分量 %1，空腔 %2，隧道 %3</translation>
    </message>
    <message>
        <source>Distance to “%1”: %2</source>
        <translation>到“%1”的距离：%2</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>壁厚</translation>
    </message>
    <message>
        <source>Length %1, in “%2”</source>
        <translation>长度 %1，在“%2”中</translation>
    </message>
    <message>
        <source>Least section: %1</source>
        <translation>最小截面：%1</translation>
    </message>
    <message>
        <source>Largest: %1</source>
        <translation>最大：%1</translation>
    </message>
    <message>
        <source>at %1: no section</source>
        <translation>%1 处：无截面</translation>
    </message>
    <message>
        <source>at %1: %2 mm², Ø %3</source>
        <translation>%1 处：%2 mm²，Ø %3</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近打开(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>面板(&amp;P)</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Standard deviation of the Gaussian that smooths the image ahead. More for more speckle; 0 for none.</source>
        <translation>预先平滑图像的高斯标准差。散斑越多取值越大；0 为不平滑。</translation>
    </message>
    <message>
        <source>Edge length</source>
        <translation>边长</translation>
    </message>
    <message>
        <source>Length that the edges of the mesh are kept near. Shorter shows finer detail and takes longer.</source>
        <translation>网格边长的目标值。越短细节越多，耗时越长。</translation>
    </message>
    <message>
        <source>Balloon</source>
        <translation>气球力</translation>
    </message>
    <message>
        <source>Weight of the force that drives the surface outward. Less keeps it from leaking.</source>
        <translation>向外推动表面的力的权重。较小可防止泄漏。</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>曲率</translation>
    </message>
    <message>
        <source>Weight of smoothness. More closes narrow leaks and rounds the surface off.</source>
        <translation>光滑性的权重。较大可封闭狭窄泄漏并使表面圆滑。</translation>
    </message>
    <message>
        <source>Iteration limit</source>
        <translation>迭代上限</translation>
    </message>
    <message>
        <source>The growth stops after so many iterations, finished or not.</source>
        <translation>达到此迭代次数后停止生长，无论是否完成。</translation>
    </message>
    <message>
        <source>The file cannot be read.</source>
        <translation>无法读取文件。</translation>
    </message>
    <message>
        <source>The file cannot be written.</source>
        <translation>无法写入文件。</translation>
    </message>
    <message>
        <source>Open a volume (NIfTI, NRRD, MetaImage, GIPL, TIFF, DICOM) or a session</source>
        <translation>打开体数据（NIfTI、NRRD、MetaImage、GIPL、TIFF、DICOM）或会话</translation>
    </message>
    <message>
        <source>Open o&amp;bjects…</source>
        <translation>打开目标(&amp;B)…</translation>
    </message>
    <message>
        <source>Take surfaces of a mesh (STL, VTP, PLY, OBJ, 3MF) or a label map (DICOM, 3D Slicer, NIfTI, NRRD, MetaImage) as objects: as they are, or to grow from</source>
        <translation>将网格（STL、VTP、PLY、OBJ、3MF）或标签图（DICOM、3D Slicer、NIfTI、NRRD、MetaImage）的表面作为目标：保持原样，或由其继续生长</translation>
    </message>
    <message>
        <source>&amp;Time</source>
        <translation>时间(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>播放(&amp;P)</translation>
    </message>
    <message>
        <source>Play the frames of the volume, or stop</source>
        <translation>播放体数据的各帧，或停止</translation>
    </message>
    <message>
        <source>P&amp;revious frame</source>
        <translation>上一帧(&amp;R)</translation>
    </message>
    <message>
        <source>The frame before the shown one</source>
        <translation>所示帧的前一帧</translation>
    </message>
    <message>
        <source>&amp;Next frame</source>
        <translation>下一帧(&amp;N)</translation>
    </message>
    <message>
        <source>The frame after the shown one</source>
        <translation>所示帧的后一帧</translation>
    </message>
    <message>
        <source>&amp;Back to where it is grown</source>
        <translation>回到生长所在的帧(&amp;B)</translation>
    </message>
    <message>
        <source>The frame in which the surface is grown</source>
        <translation>表面生长所在的帧</translation>
    </message>
    <message>
        <source>&amp;Grow in this frame</source>
        <translation>在此帧中生长(&amp;G)</translation>
    </message>
    <message>
        <source>Grow in the shown frame with the same clicks; what was grown in the other one is gone</source>
        <translation>用相同的点击在所示帧中生长；另一帧中已生长的部分将消失</translation>
    </message>
    <message>
        <source>&amp;Over time</source>
        <translation>随时间(&amp;O)</translation>
    </message>
    <message>
        <source>Carry the surface from its frame through the others, both ways, in the background</source>
        <translation>在后台将表面从其所在帧向前后两个方向传递到其他帧</translation>
    </message>
    <message>
        <source>&amp;Correct this frame</source>
        <translation>修正此帧(&amp;C)</translation>
    </message>
    <message>
        <source>Change the surface of the shown frame with clicks, walls and edits, from that of the frame beside it on</source>
        <translation>从相邻帧的表面出发，用点击、屏障和编辑更改所示帧的表面</translation>
    </message>
    <message>
        <source>Carry on &amp;from here</source>
        <translation>由此继续传递(&amp;F)</translation>
    </message>
    <message>
        <source>The correction counts: the frames beyond this one are carried again from it</source>
        <translation>采用修正：此帧之后的各帧由它重新传递</translation>
    </message>
    <message>
        <source>&amp;Drop the correction</source>
        <translation>放弃修正(&amp;D)</translation>
    </message>
    <message>
        <source>Back to the frame that is grown; what was carried stays as it was</source>
        <translation>回到生长所在的帧；已传递的部分保持原样</translation>
    </message>
    <message>
        <source>&amp;Volume over time</source>
        <translation>体积随时间变化(&amp;U)</translation>
    </message>
    <message>
        <source>The volume of every frame, ejection fraction, and what went wrong in which frame</source>
        <translation>每一帧的体积、射血分数，以及哪一帧出了什么问题</translation>
    </message>
    <message>
        <source>Export &amp;meshes of all frames…</source>
        <translation>导出所有帧的网格(&amp;M)…</translation>
    </message>
    <message>
        <source>Write the surface of every frame, numbered, with a list for ParaView (.pvd) beside .vtp</source>
        <translation>写出每一帧的表面并编号，.vtp 旁附 ParaView 列表 (.pvd)</translation>
    </message>
    <message>
        <source>Export 4D &amp;label map…</source>
        <translation>导出 4D 标签图(&amp;L)…</translation>
    </message>
    <message>
        <source>Write the surfaces of all frames as one label map with four dimensions</source>
        <translation>将所有帧的表面写为一个四维标签图</translation>
    </message>
    <message>
        <source>&amp;Sensitivity</source>
        <translation>敏感性(&amp;S)</translation>
    </message>
    <message>
        <source>Grow it again with clicks, smoothing and noise a little different: how much do volume and surface change?</source>
        <translation>略微改变点击位置、平滑和噪声后重新生长：体积和表面会改变多少？</translation>
    </message>
    <message>
        <source>Export a&amp;nonymous session…</source>
        <translation>导出匿名会话(&amp;N)…</translation>
    </message>
    <message>
        <source>Write a session that names neither the patient nor a file: it asks for its volume when it is opened</source>
        <translation>写出既不含患者姓名也不含文件名的会话：打开时会询问其体数据</translation>
    </message>
    <message>
        <source>the first point lies outside of the object</source>
        <translation>第一个点位于目标之外</translation>
    </message>
    <message>
        <source>the second point lies outside of the object</source>
        <translation>第二个点位于目标之外</translation>
    </message>
    <message>
        <source>the two points lie in the same place of the object</source>
        <translation>两个点位于目标的同一处</translation>
    </message>
    <message>
        <source>the way between them is too long and thin to be searched</source>
        <translation>两点之间的通路过长过细，无法搜索</translation>
    </message>
    <message>
        <source>there is no way from one to the other inside of the object</source>
        <translation>目标内部没有从一点到另一点的通路</translation>
    </message>
    <message>
        <source>3MF files</source>
        <translation>3MF 文件</translation>
    </message>
    <message>
        <source>the outer surface</source>
        <translation>外表面</translation>
    </message>
    <message>
        <source>the cavities</source>
        <translation>空腔</translation>
    </message>
    <message>
        <source>writing DICOM files</source>
        <translation>写入 DICOM 文件</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::CentreLinePage</name>
    <message>
        <source>The centre line</source>
        <translation>中心线</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>保存为 CSV…</translation>
    </message>
    <message>
        <source>Save as CSV</source>
        <translation>保存为 CSV</translation>
    </message>
    <message>
        <source>The same table as “handlebody-cli measure --sections” writes</source>
        <translation>与“handlebody-cli measure --sections”写出的表格相同</translation>
    </message>
    <message>
        <source>Save the sections</source>
        <translation>保存截面</translation>
    </message>
    <message>
        <source>Between two places in an object, along its middle.</source>
        <translation>在目标内两处之间，沿其中部。</translation>
    </message>
    <message>
        <source>Click in the object or on its surface where the line begins, or press Return for the crosshair.</source>
        <translation>在目标内或其表面点击线的起点，或按回车使用十字线。</translation>
    </message>
    <message>
        <source>Click where it ends. Escape takes the beginning back.</source>
        <translation>点击终点。Esc 取消起点。</translation>
    </message>
    <message>
        <source>Searching for the middle of the object…</source>
        <translation>正在寻找目标的中部…</translation>
    </message>
    <message>
        <source>Pointed at: %1</source>
        <translation>指向：%1</translation>
    </message>
    <message>
        <source>It was made in an earlier surface.</source>
        <translation>它是在较早的表面中生成的。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Search no longer</source>
        <translation>停止寻找</translation>
    </message>
    <message>
        <source>Draw the line no more</source>
        <translation>不再绘制该线</translation>
    </message>
    <message>
        <source>Save as JSON…</source>
        <translation>保存为 JSON…</translation>
    </message>
    <message>
        <source>Save as JSON</source>
        <translation>保存为 JSON</translation>
    </message>
    <message>
        <source>The same as “handlebody-cli measure --json” writes of the line</source>
        <translation>与“handlebody-cli measure --json”所写的中心线相同</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ComparePage</name>
    <message>
        <source>Figure</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>The object beside the reference</source>
        <translation>目标与参考对照</translation>
    </message>
    <message>
        <source>Save the comparison</source>
        <translation>保存比较</translation>
    </message>
    <message>
        <source>Choose reference…</source>
        <translation>选择参考…</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Compare the shown surface with the reference</source>
        <translation>将所示表面与参考比较</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>保存为 CSV…</translation>
    </message>
    <message>
        <source>The same table as “handlebody-cli compare --csv” writes</source>
        <translation>与“handlebody-cli compare --csv”写出的表格相同</translation>
    </message>
    <message>
        <source>Save as JSON…</source>
        <translation>保存为 JSON…</translation>
    </message>
    <message>
        <source>The same as “handlebody-cli compare --report” writes</source>
        <translation>与“handlebody-cli compare --report”写出的相同</translation>
    </message>
    <message>
        <source>The reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>State of the comparison</source>
        <translation>比较状态</translation>
    </message>
    <message>
        <source>all but 0</source>
        <translation>除 0 以外全部</translation>
    </message>
    <message>
        <source>Which voxels of a label map are the reference</source>
        <translation>标签图中哪些体素作为参考</translation>
    </message>
    <message>
        <source>Distances in colour on the surface</source>
        <translation>以颜色在表面显示距离</translation>
    </message>
    <message>
        <source>Blue inside of the reference, red outside of it</source>
        <translation>参考内为蓝，参考外为红</translation>
    </message>
    <message>
        <source>The objects are compared</source>
        <translation>正在比较目标</translation>
    </message>
    <message>
        <source>Choose the reference</source>
        <translation>选择参考</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>No reference is chosen.</source>
        <translation>未选择参考。</translation>
    </message>
    <message>
        <source>There is no surface to compare yet: grow one first.</source>
        <translation>还没有可比较的表面：请先生长一个。</translation>
    </message>
    <message>
        <source>Comparing…</source>
        <translation>正在比较…</translation>
    </message>
    <message>
        <source>These are figures of an earlier surface, or of another object.</source>
        <translation>这些指标属于较早的表面或其他目标。</translation>
    </message>
    <message>
        <source>A mesh, a label map or another object to compare the active object with</source>
        <translation>用于与当前目标比较的网格、标签图或另一个目标</translation>
    </message>
    <message>
        <source>Save distances…</source>
        <translation>保存距离…</translation>
    </message>
    <message>
        <source>The surface with its distance from the reference at every vertex, as “handlebody-cli compare -o” writes it</source>
        <translation>表面及其每个顶点到参考的距离，与“handlebody-cli compare -o”写出的相同</translation>
    </message>
    <message>
        <source>Why no labels are listed</source>
        <translation>未列出标签的原因</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Label of the reference</source>
        <translation>参考的标签</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>来自文件…</translation>
    </message>
    <message>
        <source>Save the distances</source>
        <translation>保存距离</translation>
    </message>
    <message>
        <source>Meshes and label maps (*.stl *.vtp *.ply *.obj *.3mf *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.dcm);;All files (*)</source>
        <translation>网格和标签图 (*.stl *.vtp *.ply *.obj *.3mf *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.dcm);;所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::Document</name>
    <message>
        <source>“%1” is locked: unlock it to change it.</source>
        <translation>“%1”已锁定：解锁后才能更改。</translation>
    </message>
    <message>
        <source>Add click outside</source>
        <translation>添加外部点</translation>
    </message>
    <message>
        <source>Add seed</source>
        <translation>添加种子点</translation>
    </message>
    <message>
        <source>Delete click outside</source>
        <translation>删除外部点</translation>
    </message>
    <message>
        <source>Delete seed</source>
        <translation>删除种子点</translation>
    </message>
    <message>
        <source>Move click outside</source>
        <translation>移动外部点</translation>
    </message>
    <message>
        <source>Move seed</source>
        <translation>移动种子点</translation>
    </message>
    <message>
        <source>Change radius of click outside</source>
        <translation>更改外部点半径</translation>
    </message>
    <message>
        <source>Change seed radius</source>
        <translation>更改种子点半径</translation>
    </message>
    <message>
        <source>Smaller object</source>
        <translation>更小的目标</translation>
    </message>
    <message>
        <source>Larger object</source>
        <translation>更大的目标</translation>
    </message>
    <message>
        <source>The wall would lie outside of the volume: it is not kept.</source>
        <translation>屏障会位于体数据之外：不予保留。</translation>
    </message>
    <message>
        <source>The wall would lie over the seed at %1 mm: it is not kept.</source>
        <translation>屏障会盖住位于 %1 mm 的种子点：不予保留。</translation>
    </message>
    <message>
        <source>Paint wall</source>
        <translation>绘制屏障</translation>
    </message>
    <message>
        <source>Erase wall</source>
        <translation>擦除屏障</translation>
    </message>
    <message>
        <source>The surface has not come to rest yet: nothing is pinned.</source>
        <translation>表面尚未静止：不固定任何部分。</translation>
    </message>
    <message>
        <source>Pin here</source>
        <translation>在此固定</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>This part of the surface is pinned already.</source>
        <translation>这部分表面已固定。</translation>
    </message>
    <message>
        <source>No vertex of the surface lies within %1 mm of %2 mm: nothing is pinned.</source>
        <translation>在 %2 mm 周围 %1 mm 内没有表面顶点：不固定任何部分。</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>取消固定</translation>
    </message>
    <message>
        <source>Keep apart</source>
        <translation>保持分离</translation>
    </message>
    <message>
        <source>Keep as it is</source>
        <translation>保持原样</translation>
    </message>
    <message>
        <source>Wall here</source>
        <translation>在此设屏障</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>允许发生</translation>
    </message>
    <message>
        <source>Remove component</source>
        <translation>移除连通分量</translation>
    </message>
    <message>
        <source>Keep only one component</source>
        <translation>只保留一个连通分量</translation>
    </message>
    <message>
        <source>Fill cavity</source>
        <translation>填充空腔</translation>
    </message>
    <message>
        <source>Smooth here</source>
        <translation>在此平滑</translation>
    </message>
    <message>
        <source>Pull here</source>
        <translation>拉到此处</translation>
    </message>
    <message>
        <source>Cut here</source>
        <translation>在此切割</translation>
    </message>
    <message>
        <source>Cut handle</source>
        <translation>切断环柄</translation>
    </message>
    <message>
        <source>Fill tunnel</source>
        <translation>填充隧道</translation>
    </message>
    <message>
        <source>Close tunnel</source>
        <translation>封闭隧道</translation>
    </message>
    <message>
        <source>Leave out an edit</source>
        <translation>略去一次编辑</translation>
    </message>
    <message>
        <source>Object %1</source>
        <translation>目标 %1</translation>
    </message>
    <message>
        <source>Add object</source>
        <translation>添加目标</translation>
    </message>
    <message>
        <source>Duplicate object</source>
        <translation>复制目标</translation>
    </message>
    <message>
        <source>“%1” is locked: unlock it first.</source>
        <translation>“%1”已锁定：请先解锁。</translation>
    </message>
    <message>
        <source>Delete object</source>
        <translation>删除目标</translation>
    </message>
    <message>
        <source>Move object in the list</source>
        <translation>在列表中移动目标</translation>
    </message>
    <message>
        <source>Another object is called “%1”.</source>
        <translation>另一个目标已叫“%1”。</translation>
    </message>
    <message>
        <source>“%1” has the label value %2.</source>
        <translation>“%1”的标签值为 %2。</translation>
    </message>
    <message>
        <source>Show object</source>
        <translation>显示目标</translation>
    </message>
    <message>
        <source>Hide object</source>
        <translation>隐藏目标</translation>
    </message>
    <message>
        <source>Lock object</source>
        <translation>锁定目标</translation>
    </message>
    <message>
        <source>Unlock object</source>
        <translation>解锁目标</translation>
    </message>
    <message>
        <source>“%1” meets “%2”, and nothing was written: grow it anew, so that it keeps clear.</source>
        <translation>“%1”与“%2”相接触，未写入任何内容：请重新生长使其保持距离。</translation>
    </message>
    <message>
        <source>There is no surface to export yet: grow one first.</source>
        <translation>还没有可导出的表面：请先生长一个。</translation>
    </message>
    <message>
        <source>Nothing is left of the surface at this iteration: step back to one that has some.</source>
        <translation>此次迭代时表面已不存在：请退回到尚有表面的迭代。</translation>
    </message>
    <message>
        <source>There is no surface to report on yet: grow one first.</source>
        <translation>还没有可报告的表面：请先生长一个。</translation>
    </message>
    <message>
        <source>There is nothing to save yet: open a volume first.</source>
        <translation>还没有可保存的内容：请先打开体数据。</translation>
    </message>
    <message>
        <source>A session needs a seed: place one inside the object first.</source>
        <translation>会话需要种子点：请先在目标内放置一个。</translation>
    </message>
    <message>
        <source>There is no seed yet: place one inside the object first.</source>
        <translation>还没有种子点：请先在目标内放置一个。</translation>
    </message>
    <message>
        <source>Hold it</source>
        <translation>阻止</translation>
    </message>
    <message>
        <source>The volume has one time point only.</source>
        <translation>体数据只有一个时间点。</translation>
    </message>
    <message>
        <source>Frame %1 is being corrected: end that first.</source>
        <translation>正在修正第 %1 帧：请先结束修正。</translation>
    </message>
    <message>
        <source>In this frame the surface is grown: change it there as ever.</source>
        <translation>表面在此帧中生长：请照常在此更改。</translation>
    </message>
    <message>
        <source>The surface is being carried: wait until that is done, or cancel it.</source>
        <translation>正在传递表面：请等待完成，或取消。</translation>
    </message>
    <message>
        <source>The surface has not been carried to this frame yet.</source>
        <translation>表面尚未传递到此帧。</translation>
    </message>
    <message>
        <source>The correction has no surface at rest yet: let it grow, or pause it.</source>
        <translation>修正尚无静止的表面：请让其生长，或暂停。</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>屏障</translation>
    </message>
    <message>
        <source>Wall disc</source>
        <translation>屏障圆盘</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>Veto</source>
        <translation>否决</translation>
    </message>
    <message>
        <source>Edit by hand</source>
        <translation>手动编辑</translation>
    </message>
    <message>
        <source>Limits of the topology</source>
        <translation>拓扑限制</translation>
    </message>
    <message>
        <source>Decided: let it happen</source>
        <translation>已决定：允许发生</translation>
    </message>
    <message>
        <source>Decided: hold it</source>
        <translation>已决定：阻止</translation>
    </message>
    <message>
        <source>Clicks</source>
        <translation>点击</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>A frame is being corrected: end that first.</source>
        <translation>正在修正一帧：请先结束修正。</translation>
    </message>
    <message>
        <source>Open object</source>
        <translation>打开目标</translation>
    </message>
    <message>
        <source>Open objects</source>
        <translation>打开目标</translation>
    </message>
    <message>
        <source>Frame %1 is shown, and the surface is grown in frame %2: go there to change it.</source>
        <translation>所示为第 %1 帧，而表面在第 %2 帧中生长：请转到那里更改。</translation>
    </message>
    <message>
        <source>Grow in frame %1</source>
        <translation>在第 %1 帧中生长</translation>
    </message>
    <message>
        <source>Several objects are not carried over time: open the volume with one of them.</source>
        <translation>多个目标不能随时间传递：请只用其中一个打开体数据。</translation>
    </message>
    <message>
        <source>The surface still grows: wait until it is at rest.</source>
        <translation>表面仍在生长：请等待其静止。</translation>
    </message>
    <message>
        <source>There is no surface yet: grow one in a frame first.</source>
        <translation>尚无表面：请先在一帧中生长表面。</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>随时间</translation>
    </message>
    <message>
        <source>There are no surfaces over time of what is shown: carry it through the frames first.</source>
        <translation>所示内容没有随时间变化的表面：请先将其传递到各帧。</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>There is no surface yet: grow one first.</source>
        <translation>还没有表面：请先生长一个。</translation>
    </message>
    <message>
        <source>It is told of the frame that the surface is grown in: go there first.</source>
        <translation>仅针对表面生长所在的帧：请先转到那里。</translation>
    </message>
    <message>
        <source>It is told of a surface that has come to rest: let it grow to its end first.</source>
        <translation>仅针对已静止的表面：请先让其生长完成。</translation>
    </message>
    <message>
        <source>polished: %1 bad places, now %2; least angle %3°, was %4°.</source>
        <translation>已改善：原有 %1 处不良，现为 %2 处；最小角 %3°，原为 %4°。</translation>
    </message>
    <message>
        <source>“%1” %2</source>
        <translation>“%1”%2</translation>
    </message>
    <message>
        <source>A surface that comes from a file is not carried over time: grow one from a click.</source>
        <translation>来自文件的表面不随时间传递：请从一次点击生长出一个表面。</translation>
    </message>
    <message>
        <source>The name is empty.</source>
        <translation>名称为空。</translation>
    </message>
    <message>
        <source>The name “%1” is not UTF-8.</source>
        <translation>名称“%1”不是 UTF-8。</translation>
    </message>
    <message>
        <source>The name “%1” has more than %2 characters.</source>
        <translation>名称“%1”超过 %2 个字符。</translation>
    </message>
    <message>
        <source>The name “%1” holds a control character.</source>
        <translation>名称“%1”含有控制字符。</translation>
    </message>
    <message>
        <source>The name “%1” holds %2, which separates in some of the formats.</source>
        <translation>名称“%1”含有 %2，它在某些格式中是分隔符。</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>%1 cannot be written: it would be a part of the volume that is open. Choose another folder or name.</source>
        <translation>无法写入 %1：它会成为已打开体数据的一部分。请选择其他文件夹或名称。</translation>
    </message>
    <message>
        <source>A session keeps work over time of one object only: save this one, then open the volume anew to have several objects.</source>
        <translation>会话只保存一个对象随时间的工作：请先保存当前会话，再重新打开体数据以建立多个对象。</translation>
    </message>
    <message>
        <source>“%1” still grows: wait until it is at rest, or pause it.</source>
        <translation>“%1”仍在生长：请等它静止，或将其暂停。</translation>
    </message>
    <message>
        <source>%1 cannot be written: the open work is read from it. Choose another folder or name.</source>
        <translation>无法写入 %1：打开的工作从中读取。请选择其他文件夹或名称。</translation>
    </message>
    <message>
        <source>Work over time is left out while there are several objects: delete all but one to keep it.</source>
        <translation>有多个对象时不保存随时间的工作：请只保留一个对象以保存它。</translation>
    </message>
    <message>
        <source>“%1” is locked: unlock it to grow in another frame.</source>
        <translation>“%1”已锁定：请先解锁，再在另一帧中生长。</translation>
    </message>
    <message>
        <source>Nothing is kept for the case that the program ends unexpectedly: save the session. %1</source>
        <translation>若程序意外退出，将没有任何内容被保留：请保存会话。%1</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>Of the frames %1–%2 the surface is in these only: %3. Carry it through all of them first.</source>
        <translation>在帧 %1–%2 中，只有以下帧有表面：%3。请先将其传递到所有帧。</translation>
    </message>
    <message>
        <source>Frames %1: %2</source>
        <translation>帧 %1：%2</translation>
    </message>
    <message>
        <source>The surface is still grown in frame %1: frame %2 was not shown.</source>
        <translation>表面仍在帧 %1 中生长：帧 %2 未被显示。</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::EventInspector</name>
    <message>
        <source>Stage 1 of 4: the triangles that run into each other.</source>
        <translation>阶段 1/4：相互碰撞的三角形。</translation>
    </message>
    <message>
        <source>Stage 2 of 4: the mesh without them, and the polygons that bound the openings.</source>
        <translation>阶段 2/4：去除它们后的网格及开口的边界多边形。</translation>
    </message>
    <message>
        <source>Stage 3 of 4: the handle, or the caps, that close the openings.</source>
        <translation>阶段 3/4：封闭开口的环柄或盖。</translation>
    </message>
    <message>
        <source>Stage 4 of 4: the mesh with the handle in place.</source>
        <translation>阶段 4/4：装上环柄后的网格。</translation>
    </message>
    <message>
        <source>Before stage 2: the edges around them are halved, or the openings would not be bounded by simple polygons.</source>
        <translation>阶段 2 之前：将其周围的边对半分开，否则开口的边界不是简单多边形。</translation>
    </message>
    <message>
        <source>Handle inserted</source>
        <translation>插入环柄</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>分裂</translation>
    </message>
    <message>
        <source>Enclosed part cut off</source>
        <translation>切除被包围部分</translation>
    </message>
    <message>
        <source>Tunnel closed</source>
        <translation>隧道闭合</translation>
    </message>
    <message>
        <source>Component deleted</source>
        <translation>删除连通分量</translation>
    </message>
    <message>
        <source>Handle cut</source>
        <translation>切断环柄</translation>
    </message>
    <message>
        <source>Component removed</source>
        <translation>移除连通分量</translation>
    </message>
    <message>
        <source>Cavity filled</source>
        <translation>填充空腔</translation>
    </message>
    <message>
        <source>Fold smoothed</source>
        <translation>褶皱已平滑</translation>
    </message>
    <message>
        <source>Cut by a plane</source>
        <translation>平面切割</translation>
    </message>
    <message>
        <source>Smoothed by hand</source>
        <translation>手动平滑</translation>
    </message>
    <message>
        <source>Pulled</source>
        <translation>已拉动</translation>
    </message>
    <message>
        <source>Rolled back</source>
        <translation>已回退</translation>
    </message>
    <message>
        <source>Held: %1</source>
        <translation>已阻止：%1</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>Collide</source>
        <translation>碰撞</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>环柄</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>闭合</translation>
    </message>
    <message>
        <source>Show the whole surface</source>
        <translation>显示整个表面</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>细化</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Event: %1</source>
        <translation>事件：%1</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>位于 %1</translation>
    </message>
    <message>
        <source>Genus %1, components %2</source>
        <translation>亏格 %1，连通分量 %2</translation>
    </message>
    <message>
        <source>Edit by hand: %1 → %2</source>
        <translation>手动编辑：%1 → %2</translation>
    </message>
    <message>
        <source>Loop of %1</source>
        <translation>环长 %1</translation>
    </message>
    <message>
        <source>Fronts joined: %1</source>
        <translation>连接的前沿：%1</translation>
    </message>
    <message>
        <source>Boundary polygons of %1 vertices</source>
        <translation>边界多边形顶点数：%1</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>允许发生</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>略去</translation>
    </message>
    <message>
        <source>Keep apart here</source>
        <translation>在此保持分离</translation>
    </message>
    <message>
        <source>Goes back to the step before this edit, and on without it</source>
        <translation>退回到此编辑之前的一步并不经它继续</translation>
    </message>
    <message>
        <source>Goes back to the step before; grown on from there, this does not happen</source>
        <translation>退回到前一步；由此继续生长则不会发生</translation>
    </message>
    <message>
        <source>From the shown step on, what is held here may happen</source>
        <translation>从所示步起，此处被阻止的变化可以发生</translation>
    </message>
    <message>
        <source>The step is worked out again…</source>
        <translation>正在重新计算该步…</translation>
    </message>
    <message>
        <source>The mesh was not opened here: there are no stages to show.</source>
        <translation>网格未在此处打开：没有可显示的阶段。</translation>
    </message>
    <message>
        <source>Nothing was refined here: the polygons were simple.</source>
        <translation>此处没有细化：多边形本来就是简单的。</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::EventTable</name>
    <message>
        <source>Step</source>
        <translation>步</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Place (LPS)</source>
        <translation>位置 (LPS)</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>亏格</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>部分</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ExportPanel</name>
    <message>
        <source>Surface or label map</source>
        <translation>表面或标签图</translation>
    </message>
    <message>
        <source>Nothing has grown yet. Place a seed and start the growth first.</source>
        <translation>尚未生长。请先放置种子点并开始生长。</translation>
    </message>
    <message>
        <source>All objects in one file</source>
        <translation>所有目标写入一个文件</translation>
    </message>
    <message>
        <source>The active object</source>
        <translation>当前目标</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>A surface keeps all detail; a label map has the voxels of the volume</source>
        <translation>表面保留全部细节；标签图使用体数据的体素</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>坐标</translation>
    </message>
    <message>
        <source>LPS</source>
        <translation>LPS</translation>
    </message>
    <message>
        <source>RAS</source>
        <translation>RAS</translation>
    </message>
    <message>
        <source>x to the patient's left, y to the back, as in DICOM and ITK</source>
        <translation>x 指向患者左侧，y 指向背侧，与 DICOM 和 ITK 一致</translation>
    </message>
    <message>
        <source>x to the patient's right, y to the front, as in NIfTI and 3D Slicer</source>
        <translation>x 指向患者右侧，y 指向腹侧，与 NIfTI 和 3D Slicer 一致</translation>
    </message>
    <message>
        <source>Why nothing is written</source>
        <translation>为何未写入</translation>
    </message>
    <message>
        <source>What is written</source>
        <translation>写入的内容</translation>
    </message>
    <message>
        <source>STL surface, binary</source>
        <translation>STL 表面（二进制）</translation>
    </message>
    <message>
        <source>VTP surface (VTK)</source>
        <translation>VTP 表面 (VTK)</translation>
    </message>
    <message>
        <source>PLY surface, binary</source>
        <translation>PLY 表面（二进制）</translation>
    </message>
    <message>
        <source>OBJ surface</source>
        <translation>OBJ 表面</translation>
    </message>
    <message>
        <source>3MF surface, to print</source>
        <translation>3MF 表面（用于打印）</translation>
    </message>
    <message>
        <source>NIfTI label map</source>
        <translation>NIfTI 标签图</translation>
    </message>
    <message>
        <source>NRRD label map</source>
        <translation>NRRD 标签图</translation>
    </message>
    <message>
        <source>MetaImage label map</source>
        <translation>MetaImage 标签图</translation>
    </message>
    <message>
        <source>3D Slicer segmentation</source>
        <translation>3D Slicer 分割</translation>
    </message>
    <message>
        <source>DICOM segmentation</source>
        <translation>DICOM 分割</translation>
    </message>
    <message>
        <source>DICOM with STL surface</source>
        <translation>含 STL 表面的 DICOM</translation>
    </message>
    <message>
        <source>Gmsh tetrahedra</source>
        <translation>Gmsh 四面体</translation>
    </message>
    <message>
        <source>VTK tetrahedra</source>
        <translation>VTK 四面体</translation>
    </message>
    <message>
        <source>Abaqus tetrahedra</source>
        <translation>Abaqus 四面体</translation>
    </message>
    <message>
        <source>Without what names the patient</source>
        <translation>不含患者信息</translation>
    </message>
    <message>
        <source>What is being written</source>
        <translation>正在写入的内容</translation>
    </message>
    <message>
        <source>A file is being written</source>
        <translation>正在写入文件</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Cancel writing</source>
        <translation>取消写入</translation>
    </message>
    <message>
        <source>Writing %1…</source>
        <translation>正在写入 %1…</translation>
    </message>
    <message>
        <source>It was cancelled: nothing was written.</source>
        <translation>已取消：未写入任何内容。</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>All four views</source>
        <translation>全部四个视图</translation>
    </message>
    <message>
        <source>%1 view</source>
        <translation>%1视图</translation>
    </message>
    <message>
        <source>Picture of</source>
        <translation>图片内容</translation>
    </message>
    <message>
        <source>Which view is written as PNG</source>
        <translation>哪个视图写为 PNG</translation>
    </message>
    <message>
        <source>Report and session</source>
        <translation>报告和会话</translation>
    </message>
    <message>
        <source>The report holds every parameter, number and event. A session opens here again, and “handlebody-cli replay” makes the same mesh of it.</source>
        <translation>报告包含所有参数、数值和事件。会话可在此重新打开，“handlebody-cli replay”可由其生成相同网格。</translation>
    </message>
    <message>
        <source>Objects: %1; %2 together.</source>
        <translation>目标：%1；共 %2。</translation>
    </message>
    <message>
        <source>Without a surface: %1.</source>
        <translation>无表面：%1。</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>Made with earlier surfaces: %1. Nothing is written if any of them meet.</source>
        <translation>用较早的表面生成：%1。如有相接触则不写入。</translation>
    </message>
    <message>
        <source>Nothing is left of the surface at this iteration.</source>
        <translation>此次迭代时表面已不存在。</translation>
    </message>
    <message>
        <source>Iteration %1: %2, %3</source>
        <translation>第 %1 次迭代：%2，%3</translation>
    </message>
    <message>
        <source>What was bettered</source>
        <translation>改善的内容</translation>
    </message>
    <message>
        <source>glTF scene, to view</source>
        <translation>glTF 场景，用于查看</translation>
    </message>
    <message>
        <source>Better thin triangles</source>
        <translation>改善细长三角形</translation>
    </message>
    <message>
        <source>Triangles with an angle under 15° and edges sharper than 20°, which a solver cannot use, are made better in what is written; the surface goes no farther than a tenth of a voxel. The session keeps this choice.</source>
        <translation>写出时改善求解器无法使用的三角形（角小于 15°）和边（锐于 20°）；表面移动不超过体素的十分之一。会话保存此选择。</translation>
    </message>
    <message>
        <source>Bettering the triangles of “%1”…</source>
        <translation>正在改善“%1”的三角形…</translation>
    </message>
    <message>
        <source>Bettering the triangles…</source>
        <translation>正在改善三角形…</translation>
    </message>
    <message>
        <source>Creator</source>
        <translation>创建者</translation>
    </message>
    <message>
        <source>Who made it, as DICOM writes names: Family^Given. May stay empty</source>
        <translation>创建人，按 DICOM 的姓名写法：姓^名。可留空</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>说明</translation>
    </message>
    <message>
        <source>What it is for. May stay empty</source>
        <translation>用途。可留空</translation>
    </message>
    <message>
        <source>ITK-SNAP label description</source>
        <translation>ITK-SNAP 标签说明</translation>
    </message>
    <message>
        <source>DICOM files, report and measures are written without patient, study, dates and names of files, and the names that are suggested do not tell the volume's. In place of saving the session one is exported that does not say where its volume is: it asks for it when it is opened.</source>
        <translation>DICOM 文件、报告和测量结果写出时不含患者、检查、日期和文件名，建议的名称也不透露体数据的名称。不保存会话，而是导出一个不说明体数据位置的会话：打开时会询问。</translation>
    </message>
    <message>
        <source>Each object in a file of its own</source>
        <translation>每个对象各存一个文件</translation>
    </message>
    <message>
        <source>What a file holds: names and colours stay apart where it can; to the name of a file of one object its name is added</source>
        <translation>文件所含内容：格式允许时名称和颜色保持独立；单个对象的文件名后会加上该对象的名称</translation>
    </message>
    <message>
        <source>Nothing is left of the file, nor of those that wait</source>
        <translation>该文件及等待中的文件都不会保留</translation>
    </message>
    <message>
        <source>Waiting: %1.</source>
        <translation>等待中：%1。</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::FileWork</name>
    <message>
        <source>%1 is written.</source>
        <translation>已写入 %1。</translation>
    </message>
    <message>
        <source>The session is saved as %1.</source>
        <translation>会话已保存为 %1。</translation>
    </message>
    <message>
        <source>A replay grows anew: %1.</source>
        <translation>重放会重新生长：%1。</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>Open a volume or a session</source>
        <translation>打开体数据或会话</translation>
    </message>
    <message>
        <source>Open a folder with a DICOM series</source>
        <translation>打开含 DICOM 序列的文件夹</translation>
    </message>
    <message>
        <source>Enter the spacing</source>
        <translation>输入间距</translation>
    </message>
    <message>
        <source>The sample is not installed with this program.</source>
        <translation>本程序未安装示例。</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>未保存的工作</translation>
    </message>
    <message>
        <source>Save the seeds and parameters first?</source>
        <translation>是否先保存种子点和参数？</translation>
    </message>
    <message>
        <source>They are kept in a session, from which the same surface can be grown again.</source>
        <translation>它们保存在会话中，可由此再次生长出相同的表面。</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>保存会话</translation>
    </message>
    <message>
        <source>Sessions (*.json)</source>
        <translation>会话 (*.json)</translation>
    </message>
    <message>
        <source>Export the result</source>
        <translation>导出结果</translation>
    </message>
    <message>
        <source>Export the report</source>
        <translation>导出报告</translation>
    </message>
    <message>
        <source>Export a picture</source>
        <translation>导出图片</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>无法写入 %1：%2。</translation>
    </message>
    <message>
        <source>The program ended unexpectedly last time. Its seeds and parameters were kept.</source>
        <translation>程序上次意外结束，其种子点和参数已保留。</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>丢弃</translation>
    </message>
    <message>
        <source>Volumes and sessions (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.tif *.tiff *.dcm *.json);;All files (*)</source>
        <translation>体数据和会话 (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.tif *.tiff *.dcm *.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Open a mesh or a label map</source>
        <translation>打开网格或标签图</translation>
    </message>
    <message>
        <source>Open objects</source>
        <translation>打开目标</translation>
    </message>
    <message>
        <source>Making surfaces of %1…</source>
        <translation>正在由 %1 生成表面…</translation>
    </message>
    <message>
        <source>%1 is open as: %2.</source>
        <translation>%1 已打开为：%2。</translation>
    </message>
    <message>
        <source>%1 is a surface: open the volume first that it lies in.</source>
        <translation>%1 是表面：请先打开其所在的体数据。</translation>
    </message>
    <message>
        <source>Export a 4D label map</source>
        <translation>导出 4D 标签图</translation>
    </message>
    <message>
        <source>Export the meshes of all frames</source>
        <translation>导出所有帧的网格</translation>
    </message>
    <message>
        <source>Choose the file…</source>
        <translation>选择文件…</translation>
    </message>
    <message>
        <source>Choose the folder…</source>
        <translation>选择文件夹…</translation>
    </message>
    <message>
        <source>Choose what the session needs</source>
        <translation>选择会话所需的内容</translation>
    </message>
    <message>
        <source>Export an anonymous session</source>
        <translation>导出匿名会话</translation>
    </message>
    <message>
        <source>Segments overlap: what several of them hold is left to the smallest (voxels: %1). Step 4, Grow, tells it of each.</source>
        <translation>分割区有重叠：多个分割区共有的部分归最小者（体素数：%1）。第 4 步“生长”说明每个目标的情况。</translation>
    </message>
    <message>
        <source>Meshes and label maps (*.stl *.vtp *.ply *.obj *.3mf *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.dcm);;All files (*)</source>
        <translation>网格和标签图 (*.stl *.vtp *.ply *.obj *.3mf *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.dcm);;所有文件 (*)</translation>
    </message>
    <message>
        <source>There already: %1. Replace what is there?</source>
        <translation>已存在：%1。要替换吗？</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>另外 %1 个</translation>
    </message>
    <message>
        <source>A file is being written. The window closes when it is done.</source>
        <translation>正在写入文件。完成后窗口将关闭。</translation>
    </message>
    <message>
        <source>Stay open</source>
        <translation>保持打开</translation>
    </message>
    <message>
        <source>%1 was changed elsewhere since it was opened or saved here. Replace what is there?</source>
        <translation>%1 自在此处打开或保存后已在别处被更改。要替换现有内容吗？</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>覆盖</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>另存为…</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::FrameSlider</name>
    <message>
        <source>Frame</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>&lt;p&gt;Time: the frames of the volume. A ring is the frame the surface is grown in, dots are frames it was carried to: orange with a warning, red where it failed. Click or drag to go there.&lt;/p&gt;</source>
        <translation>&lt;p&gt;时间：体数据的各帧。圆环为表面生长所在的帧，圆点为已传递到的帧：橙色表示有警告，红色表示失败。点击或拖动以到达。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::GrowPanel</name>
    <message>
        <source>not closed</source>
        <translation>未闭合</translation>
    </message>
    <message>
        <source>not manifold</source>
        <translation>非流形</translation>
    </message>
    <message>
        <source>not oriented</source>
        <translation>未定向</translation>
    </message>
    <message>
        <source>self-intersections: %1</source>
        <translation>自相交：%1</translation>
    </message>
    <message>
        <source>parts that lie wrongly in each other: %1</source>
        <translation>嵌套错误的部分：%1</translation>
    </message>
    <message>
        <source>self-intersections not checked</source>
        <translation>未检查自相交</translation>
    </message>
    <message>
        <source>Finished: the surface is at rest</source>
        <translation>完成：表面已静止</translation>
    </message>
    <message>
        <source>Stopped at the iteration limit</source>
        <translation>已达迭代上限</translation>
    </message>
    <message>
        <source>Finished: nothing is left of the surface</source>
        <translation>完成：表面已不存在</translation>
    </message>
    <message>
        <source>At rest, but parts that could not be mended would still move</source>
        <translation>已静止，但无法修复的部分仍会移动</translation>
    </message>
    <message>
        <source>Stuck: no part of a step could be kept</source>
        <translation>已卡住：无法保留一步中的任何部分</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>⚠ Worth a look</source>
        <translation>⚠ 值得查看</translation>
    </message>
    <message>
        <source>iteration %1 of %2</source>
        <translation>迭代 %1 / %2</translation>
    </message>
    <message>
        <source>Preparing the image…</source>
        <translation>正在准备图像…</translation>
    </message>
    <message>
        <source>Growing</source>
        <translation>生长中</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>已暂停</translation>
    </message>
    <message>
        <source>No seed yet</source>
        <translation>还没有种子点</translation>
    </message>
    <message>
        <source>Ready to grow</source>
        <translation>可以生长</translation>
    </message>
    <message>
        <source>Nothing grew</source>
        <translation>没有生长</translation>
    </message>
    <message>
        <source>These clicks mean another object: begun anew at iteration %1</source>
        <translation>这些点击指向另一目标：在第 %1 次迭代重新开始</translation>
    </message>
    <message>
        <source>Clicks changed at iteration %1: gone on from there</source>
        <translation>第 %1 次迭代更改了点击：由此继续</translation>
    </message>
    <message>
        <source>Start grows the surface from the seeds. You may pause, go back exactly, change a click or a parameter and go on from there at any time.</source>
        <translation>“开始”使表面从种子点生长。可随时暂停、精确后退、更改点击或参数并由此继续。</translation>
    </message>
    <message>
        <source>State of the growth</source>
        <translation>生长状态</translation>
    </message>
    <message>
        <source>Why it did not grow</source>
        <translation>为何没有生长</translation>
    </message>
    <message>
        <source>Doubts about the surface</source>
        <translation>对表面的疑问</translation>
    </message>
    <message>
        <source>Steps per frame</source>
        <translation>每帧步数</translation>
    </message>
    <message>
        <source>How many iterations the surface goes on between two pictures of it</source>
        <translation>两帧之间表面前进的迭代数</translation>
    </message>
    <message>
        <source>Pause at a leak</source>
        <translation>泄漏时暂停</translation>
    </message>
    <message>
        <source>The growth pauses where the surface has come through a passage much narrower than what lies on both sides of it</source>
        <translation>当表面穿过比两侧窄得多的通道时生长暂停</translation>
    </message>
    <message>
        <source>Surface now</source>
        <translation>当前表面</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>认证</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>Volume enclosed by the surface</source>
        <translation>表面所围体积</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>Area of the surface</source>
        <translation>表面面积</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>连通分量</translation>
    </message>
    <message>
        <source>Connected parts of the surface</source>
        <translation>表面的连通部分</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>亏格</translation>
    </message>
    <message>
        <source>Holes as in a ring: in all, and of each component</source>
        <translation>环形孔数：总数及各分量</translation>
    </message>
    <message>
        <source>Euler number</source>
        <translation>欧拉数</translation>
    </message>
    <message>
        <source>Vertices minus edges plus faces</source>
        <translation>顶点数减边数加面数</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>Vertices of the mesh</source>
        <translation>网格顶点数</translation>
    </message>
    <message>
        <source>Nothing is left of the surface</source>
        <translation>表面已不存在</translation>
    </message>
    <message>
        <source>✓ Closed, manifold, free of self-intersections</source>
        <translation>✓ 闭合、流形、无自相交</translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>As it was opened: nothing grows</source>
        <translation>保持打开时的样子：不生长</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::HeldSection</name>
    <message>
        <source>What is held back</source>
        <translation>被阻止的变化</translation>
    </message>
    <message>
        <source>Nothing is held back.</source>
        <translation>没有被阻止的变化。</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Where (mm LPS)</source>
        <translation>位置 (mm LPS)</translation>
    </message>
    <message>
        <source>What is held back, each with its place</source>
        <translation>被阻止的变化及其位置</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>解除</translation>
    </message>
    <message>
        <source>At most %1 components</source>
        <translation>最多 %1 个连通分量</translation>
    </message>
    <message>
        <source>Lift the limit</source>
        <translation>解除限制</translation>
    </message>
    <message>
        <source>Genus at most %1</source>
        <translation>亏格最多 %1</translation>
    </message>
    <message>
        <source>May break the limits</source>
        <translation>可超出限制</translation>
    </message>
    <message>
        <source>Allow no more</source>
        <translation>不再允许</translation>
    </message>
    <message>
        <source>Veto at iteration %1</source>
        <translation>第 %1 次迭代的否决</translation>
    </message>
    <message>
        <source>Lift the veto</source>
        <translation>解除否决</translation>
    </message>
    <message>
        <source>Pin at iteration %1</source>
        <translation>第 %1 次迭代的固定</translation>
    </message>
    <message>
        <source>%1, %2 balls</source>
        <translation>%1，%2 个球</translation>
    </message>
    <message>
        <source>Lift the pin</source>
        <translation>解除固定</translation>
    </message>
    <message>
        <source>Disc, radius %1</source>
        <translation>圆盘，半径 %1</translation>
    </message>
    <message>
        <source>Lift the disc</source>
        <translation>解除圆盘</translation>
    </message>
    <message>
        <source>Walls of %1</source>
        <translation>来自 %1 的屏障</translation>
    </message>
    <message>
        <source>Lift the map of walls</source>
        <translation>解除屏障图</translation>
    </message>
    <message>
        <source>Held: %1</source>
        <translation>已阻止：%1</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>允许发生</translation>
    </message>
    <message>
        <source>From the shown iteration on the chosen one holds nothing back</source>
        <translation>从所示迭代起所选项不再阻止</translation>
    </message>
    <message>
        <source>Held, as you decided</source>
        <translation>按您的决定阻止</translation>
    </message>
    <message>
        <source>Decide again</source>
        <translation>重新决定</translation>
    </message>
    <message>
        <source>To decide: %1</source>
        <translation>待决定：%1</translation>
    </message>
    <message>
        <source>%1 around</source>
        <translation>周长 %1</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::HelpWindow</name>
    <message>
        <source>Handlebody: help</source>
        <translation>Handlebody：帮助</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>指南</translation>
    </message>
    <message>
        <source>Keyboard and mouse</source>
        <translation>键盘和鼠标</translation>
    </message>
    <message>
        <source>About</source>
        <translation>关于</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::HistogramView</name>
    <message>
        <source>Histogram with the object's range</source>
        <translation>带目标范围的直方图</translation>
    </message>
    <message>
        <source>&lt;p&gt;How often each intensity occurs (square root). Drag the ends of the object's range; with the keyboard: Up and Down choose an end, Left and Right move it.&lt;/p&gt;</source>
        <translation>&lt;p&gt;各强度出现的频度（平方根）。拖动目标范围的两端；键盘：上下键选择一端，左右键移动。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>From %1 to %2</source>
        <translation>从 %1 到 %2</translation>
    </message>
    <message>
        <source>No range yet</source>
        <translation>还没有范围</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::LabelChoice</name>
    <message>
        <source>Label %1</source>
        <translation>标签 %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>&amp;Labels to open</source>
        <translation>要打开的标签(&amp;L)</translation>
    </message>
    <message>
        <source>Labels to open</source>
        <translation>要打开的标签</translation>
    </message>
    <message>
        <source>Each that is checked becomes an object, called and coloured as the file says</source>
        <translation>每个勾选的标签成为一个目标，名称和颜色取自文件</translation>
    </message>
    <message>
        <source>&amp;All</source>
        <translation>全选(&amp;A)</translation>
    </message>
    <message>
        <source>Checks all labels</source>
        <translation>勾选所有标签</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>全不选(&amp;N)</translation>
    </message>
    <message>
        <source>Checks no label</source>
        <translation>取消勾选所有标签</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::LocalSection</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Radius at the crosshair</source>
        <translation>十字线处半径</translation>
    </message>
    <message>
        <source>Of the ball in which the surface is pinned or smoothed, and how far along it a pull reaches</source>
        <translation>固定或平滑表面的球的半径，以及拉动的影响范围</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>拉动</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>轴位</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>冠状位</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>矢状位</translation>
    </message>
    <message>
        <source>Cut as the axial slices lie</source>
        <translation>沿轴位切面方向切割</translation>
    </message>
    <message>
        <source>Cut as the coronal slices lie</source>
        <translation>沿冠状位切面方向切割</translation>
    </message>
    <message>
        <source>Cut as the sagittal slices lie</source>
        <translation>沿矢状位切面方向切割</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>两侧</translation>
    </message>
    <message>
        <source>Superior</source>
        <translation>上侧</translation>
    </message>
    <message>
        <source>Inferior</source>
        <translation>下侧</translation>
    </message>
    <message>
        <source>Both sides of the cut stay</source>
        <translation>切口两侧均保留</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>切割</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>后侧</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Anterior</source>
        <translation>前侧</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Keep: %1</source>
        <translation>保留：%1</translation>
    </message>
    <message>
        <source>Only what lies on this side of the plane stays</source>
        <translation>只保留平面此侧的部分</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::MainWindow</name>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>时间线</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>屏障</translation>
    </message>
    <message>
        <source>Paint in the slices where the surface may not go, from the shown iteration on. Ctrl+wheel changes the radius.</source>
        <translation>在切面中绘制从所示迭代起表面不得进入的区域。Ctrl+滚轮改变半径。</translation>
    </message>
    <message>
        <source>On the surface</source>
        <translation>在表面上</translation>
    </message>
    <message>
        <source>With the brush, in the slices and in 3D: drag to pin or unpin, click to smooth, drag a point to pull it. The radius is the same. A line drawn across it in a slice cuts it.</source>
        <translation>用画笔在切面和 3D 中：拖动以固定或取消固定，点击以平滑，拖动一点以拉伸。半径相同。在切面中横过表面画线可切割。</translation>
    </message>
    <message>
        <source>Held back</source>
        <translation>被阻止</translation>
    </message>
    <message>
        <source>Limits, vetoes, pins and discs. The crosshair goes to the chosen one; lifted, it holds no more from the shown iteration on.</source>
        <translation>限制、否决、固定和圆盘。十字线移到所选项；解除后从所示迭代起不再阻止。</translation>
    </message>
    <message>
        <source>At the crosshair</source>
        <translation>在十字线处</translation>
    </message>
    <message>
        <source>A pin holds the surface in a ball. To smooth, pull and cut is the next step.</source>
        <translation>固定使球内的表面保持不变。平滑、拉动和切割作为下一步。</translation>
    </message>
    <message>
        <source>The surface is pinned here from iteration %1 on.</source>
        <translation>表面从第 %1 次迭代起在此固定。</translation>
    </message>
    <message>
        <source>Tunnels and pieces</source>
        <translation>隧道和部分</translation>
    </message>
    <message>
        <source>What the shown surface holds, and what can be done to it: each edit is the next step.</source>
        <translation>所示表面的内容及可做的操作：每次编辑为下一步。</translation>
    </message>
    <message>
        <source>Several files were dropped; the first one is opened. For a DICOM series drop its folder.</source>
        <translation>拖入了多个文件；打开第一个。DICOM 序列请拖入其文件夹。</translation>
    </message>
    <message>
        <source>The language changes when the program is started again.</source>
        <translation>重新启动程序后语言生效。</translation>
    </message>
    <message>
        <source>P&amp;ause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1: %2, was %3.</source>
        <translation>%1：%2，原为 %3。</translation>
    </message>
    <message>
        <source>A leak at iteration %1: %2.</source>
        <translation>第 %1 次迭代发生泄漏：%2。</translation>
    </message>
    <message>
        <source>Wall here</source>
        <translation>在此设屏障</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>“%1” came through a narrow passage.</source>
        <translation>“%1”穿过了狭窄通道。</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>测量值</translation>
    </message>
    <message>
        <source>Handlebody</source>
        <translation>Handlebody</translation>
    </message>
    <message>
        <source>%1[*] – Handlebody</source>
        <translation>%1[*] – Handlebody</translation>
    </message>
    <message>
        <source>Handlebody[*]</source>
        <translation>Handlebody[*]</translation>
    </message>
    <message>
        <source>Remove all walls</source>
        <translation>移除所有屏障</translation>
    </message>
    <message>
        <source>Remove all pins</source>
        <translation>移除所有固定</translation>
    </message>
    <message>
        <source>The surface is already where the wall is.</source>
        <translation>表面已在屏障所在之处。</translation>
    </message>
    <message>
        <source>Go back to before it came in here</source>
        <translation>退回到进入之前</translation>
    </message>
    <message>
        <source>Push it out</source>
        <translation>推出</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>允许发生</translation>
    </message>
    <message>
        <source>Hold it</source>
        <translation>阻止</translation>
    </message>
    <message>
        <source>“%1” has paused: a change of its topology is held, for you to decide.</source>
        <translation>“%1”已暂停：其一处拓扑变化被阻止，请您决定。</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>随时间</translation>
    </message>
    <message>
        <source>&amp;Stop playing</source>
        <translation>停止播放(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>播放(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Over time</source>
        <translation>随时间(&amp;O)</translation>
    </message>
    <message>
        <source>These objects lose their surfaces, too, and undo does not bring them back: %1. Grow in this frame?</source>
        <translation>以下对象也会失去其表面，且无法撤销恢复：%1。在此帧中生长吗？</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>Grow in this frame</source>
        <translation>在此帧中生长</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::Measurements</name>
    <message>
        <source>Ruler %1</source>
        <translation>标尺 %1</translation>
    </message>
    <message>
        <source>Angle %1</source>
        <translation>角度 %1</translation>
    </message>
    <message>
        <source>Add ruler</source>
        <translation>添加标尺</translation>
    </message>
    <message>
        <source>Add angle</source>
        <translation>添加角度</translation>
    </message>
    <message>
        <source>Move ruler</source>
        <translation>移动标尺</translation>
    </message>
    <message>
        <source>Move angle</source>
        <translation>移动角度</translation>
    </message>
    <message>
        <source>Delete ruler</source>
        <translation>删除标尺</translation>
    </message>
    <message>
        <source>Delete angle</source>
        <translation>删除角度</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::MeasuresPanel</name>
    <message>
        <source>What is measured</source>
        <translation>测量内容</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Rulers and angles</source>
        <translation>标尺和角度</translation>
    </message>
    <message>
        <source>Centre line</source>
        <translation>中心线</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>敏感性</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::MessageBar</name>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>信息</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>关闭消息</translation>
    </message>
    <message>
        <source>Close the message (Esc)</source>
        <translation>关闭消息 (Esc)</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ObjectChoice</name>
    <message>
        <source>The only one: %1</source>
        <translation>唯一：%1</translation>
    </message>
    <message>
        <source>%1 of %2 by size: %3</source>
        <translation>按大小第 %1 / %2：%3</translation>
    </message>
    <message>
        <source>%1 (likeliest)</source>
        <translation>%1（最可能）</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Which object is taken</source>
        <translation>选取哪个目标</translation>
    </message>
    <message>
        <source>Whether the choice is sure</source>
        <translation>选择是否可靠</translation>
    </message>
    <message>
        <source>A close choice: look at the others, too.</source>
        <translation>难以取舍：也请查看其他目标。</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>更小</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>更大</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ObjectDialog</name>
    <message>
        <source>Properties of the object</source>
        <translation>目标属性</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>What the object is called in the list and in files that hold names</source>
        <translation>目标在列表和含名称的文件中的名称</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Of its surface and outlines, and in files that hold colours</source>
        <translation>其表面和轮廓的颜色，以及含颜色的文件中的颜色</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>颜色(&amp;C)</translation>
    </message>
    <message>
        <source>Term</source>
        <translation>术语</translation>
    </message>
    <message>
        <source>What it is, as a code of SNOMED CT; gives the colour, too</source>
        <translation>其类别（SNOMED CT 代码）；同时决定颜色</translation>
    </message>
    <message>
        <source>&amp;Term</source>
        <translation>术语(&amp;T)</translation>
    </message>
    <message>
        <source>Label value</source>
        <translation>标签值</translation>
    </message>
    <message>
        <source>Of its voxels in a label map</source>
        <translation>其体素在标签图中的值</translation>
    </message>
    <message>
        <source>&amp;Label value</source>
        <translation>标签值(&amp;L)</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>问题所在</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Colour of the object</source>
        <translation>目标颜色</translation>
    </message>
    <message>
        <source>Change object</source>
        <translation>更改目标</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ObjectMeasuresPage</name>
    <message>
        <source>Measures of the objects</source>
        <translation>目标的测量值</translation>
    </message>
    <message>
        <source>More about the chosen object</source>
        <translation>所选目标的更多信息</translation>
    </message>
    <message>
        <source>State of the measures</source>
        <translation>测量状态</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>壁厚</translation>
    </message>
    <message>
        <source>The distance of two surfaces over their area: of two objects, or of an object and its own cavities</source>
        <translation>两个表面之间的距离：两个目标之间，或目标与其空腔之间</translation>
    </message>
    <message>
        <source>How much is measured</source>
        <translation>测量进度</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Measure the surfaces as they are shown</source>
        <translation>测量当前显示的表面</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy the table, to paste it into a spreadsheet</source>
        <translation>复制表格以粘贴到电子表格</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>保存为 CSV…</translation>
    </message>
    <message>
        <source>The same table as “handlebody-cli measure --csv” writes</source>
        <translation>与“handlebody-cli measure --csv”写出的表格相同</translation>
    </message>
    <message>
        <source>Save as JSON…</source>
        <translation>保存为 JSON…</translation>
    </message>
    <message>
        <source>The same as “handlebody-cli measure --json” writes</source>
        <translation>与“handlebody-cli measure --json”写出的相同</translation>
    </message>
    <message>
        <source>Save the measures</source>
        <translation>保存测量值</translation>
    </message>
    <message>
        <source>No wall thickness</source>
        <translation>不测壁厚</translation>
    </message>
    <message>
        <source>Wall of “%1” around its cavities</source>
        <translation>“%1”空腔周围的壁</translation>
    </message>
    <message>
        <source>Wall from “%1” to “%2”</source>
        <translation>从“%1”到“%2”的壁</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>There is no surface to measure yet: grow one first.</source>
        <translation>还没有可测量的表面：请先生长一个。</translation>
    </message>
    <message>
        <source>Measuring. What is shown is of earlier surfaces.</source>
        <translation>正在测量。所示为较早表面的数值。</translation>
    </message>
    <message>
        <source>Measuring.</source>
        <translation>正在测量。</translation>
    </message>
    <message>
        <source>These are measures of earlier surfaces.</source>
        <translation>这些是较早表面的测量值。</translation>
    </message>
    <message>
        <source>Nothing is measured yet.</source>
        <translation>尚未测量。</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ObjectsPanel</name>
    <message>
        <source>preparing</source>
        <translation>准备中</translation>
    </message>
    <message>
        <source>not grown</source>
        <translation>未生长</translation>
    </message>
    <message>
        <source>no seed</source>
        <translation>无种子点</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>What the active object is made with</source>
        <translation>当前目标的生成依据</translation>
    </message>
    <message>
        <source>%1, label value %2</source>
        <translation>%1，标签值 %2</translation>
    </message>
    <message>
        <source>Made with an earlier “%1”</source>
        <translation>用较早的“%1”生成</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>隐藏 %1</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>显示 %1</translation>
    </message>
    <message>
        <source>Its surface is drawn: hide it</source>
        <translation>其表面已绘制：点击隐藏</translation>
    </message>
    <message>
        <source>Its surface is hidden: show it</source>
        <translation>其表面已隐藏：点击显示</translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <translation>解锁 %1</translation>
    </message>
    <message>
        <source>Lock %1</source>
        <translation>锁定 %1</translation>
    </message>
    <message>
        <source>Nothing of it is changed: unlock it</source>
        <translation>不可更改：点击解锁</translation>
    </message>
    <message>
        <source>Let nothing of it be changed</source>
        <translation>禁止更改</translation>
    </message>
    <message>
        <source>Waits for “%1”, which comes before it and grows.</source>
        <translation>等待排在前面且正在生长的“%1”。</translation>
    </message>
    <message>
        <source>Made with an earlier “%1”. Start grows it anew.</source>
        <translation>用较早的“%1”生成。“开始”将重新生长。</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::OpenObjectsDialog</name>
    <message>
        <source>Open objects</source>
        <translation>打开目标</translation>
    </message>
    <message>
        <source>What are the surfaces of “%1”?</source>
        <translation>“%1”的表面作何用途？</translation>
    </message>
    <message>
        <source>Objects that are done stay as they are: locked, written with the others, and walls for objects that grow after them.

Others are where objects begin: they grow from there onto the image, or give ground.</source>
        <translation>已完成的目标保持原样：被锁定，与其他目标一起写出，并作为其后生长的目标的屏障。

否则它们是目标的起点：由此向图像生长，或退缩。</translation>
    </message>
    <message>
        <source>Reading the labels…</source>
        <translation>正在读取标签…</translation>
    </message>
    <message>
        <source>Segments that overlap</source>
        <translation>重叠的分割区</translation>
    </message>
    <message>
        <source>Segments may overlap here: voxels that several of those that are opened hold are left to the smallest of them.</source>
        <translation>此处的分割区可能重叠：所打开的多个分割区共有的体素归其中最小者。</translation>
    </message>
    <message>
        <source>How the surfaces are made</source>
        <translation>表面如何生成</translation>
    </message>
    <message>
        <source>Only the largest &amp;part</source>
        <translation>仅最大部分(&amp;P)</translation>
    </message>
    <message>
        <source>Only the largest part</source>
        <translation>仅最大部分</translation>
    </message>
    <message>
        <source>Of each label only the part with the most voxels: those that share a side</source>
        <translation>每个标签只取体素最多的部分：由共面的体素组成</translation>
    </message>
    <message>
        <source>&amp;Smoothing</source>
        <translation>平滑(&amp;S)</translation>
    </message>
    <message>
        <source>A voxel along each axis</source>
        <translation>沿各轴一个体素</translation>
    </message>
    <message>
        <source>A length</source>
        <translation>指定长度</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>How far the steps between the voxels are smoothed, as a standard deviation. None: the surface goes midway between the voxels, steps and all.</source>
        <translation>体素之间的台阶平滑到何种程度，以标准差表示。无：表面位于体素之间的正中，保留全部台阶。</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Length of the smoothing</source>
        <translation>平滑长度</translation>
    </message>
    <message>
        <source>Standard deviation; 0: none, steps and all</source>
        <translation>标准差；0：无，保留全部台阶</translation>
    </message>
    <message>
        <source>No more &amp;tunnels than</source>
        <translation>隧道不多于(&amp;T)</translation>
    </message>
    <message>
        <source>No more tunnels than</source>
        <translation>隧道不多于</translation>
    </message>
    <message>
        <source>In each surface, all of its parts together: tunnels are filled, or what goes around them is cut, whichever changes the fewest voxels</source>
        <translation>每个表面的所有部分合计：填充隧道，或切断环绕隧道之处，取改变体素最少的方式</translation>
    </message>
    <message>
        <source>Tunnels at most</source>
        <translation>隧道上限</translation>
    </message>
    <message>
        <source>Tunnels, as in a ring</source>
        <translation>隧道（如环中的孔）</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>已完成(&amp;D)</translation>
    </message>
    <message>
        <source>To &amp;grow from</source>
        <translation>由其生长(&amp;G)</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::OpenPanel</name>
    <message>
        <source>along the patient's axes</source>
        <translation>沿患者轴向</translation>
    </message>
    <message>
        <source>oblique: slices follow the volume's own axes</source>
        <translation>倾斜：切面沿体数据自身的轴</translation>
    </message>
    <message>
        <source>Open a CT, MR or ultrasound volume, a DICOM folder or a saved session; files can also be dropped on the window.</source>
        <translation>打开 CT、MR 或超声体数据、DICOM 文件夹或已保存的会话；也可将文件拖到窗口。</translation>
    </message>
    <message>
        <source>Series and stacks: choose one</source>
        <translation>序列和堆栈：请选择</translation>
    </message>
    <message>
        <source>Open this series</source>
        <translation>打开此序列</translation>
    </message>
    <message>
        <source>Open now</source>
        <translation>当前打开</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>体素</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Time point</source>
        <translation>时间点</translation>
    </message>
    <message>
        <source>The volume has several time points; one is shown and segmented</source>
        <translation>体数据有多个时间点；显示并分割其中一个</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>载入</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>  (0 to %1)</source>
        <translation>  （0 至 %1）</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::OverTimePanel</name>
    <message>
        <source>grown</source>
        <translation>已生长</translation>
    </message>
    <message>
        <source>corrected, from frame %1</source>
        <translation>已修正，来自第 %1 帧</translation>
    </message>
    <message>
        <source>carried from frame %1</source>
        <translation>由第 %1 帧传递</translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation>⚠ %1</translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>What has become of each frame</source>
        <translation>各帧的结果</translation>
    </message>
    <message>
        <source>How far the surface is carried</source>
        <translation>表面传递的进度</translation>
    </message>
    <message>
        <source>State of what is carried</source>
        <translation>传递的状态</translation>
    </message>
    <message>
        <source>Figures over time</source>
        <translation>随时间变化的数值</translation>
    </message>
    <message>
        <source>held</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Topology over time</source>
        <translation>随时间的拓扑</translation>
    </message>
    <message>
        <source>Held: no frame has other components or tunnels than the first surface. Free: it may change.</source>
        <translation>保持：所有帧的连通分量和隧道均与第一个表面相同。自由：可以改变。</translation>
    </message>
    <message>
        <source>back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>round the cycle</source>
        <translation>绕周期一圈</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Check of the way</source>
        <translation>传递过程的检查</translation>
    </message>
    <message>
        <source>Back: carried back from the ends, to see how far it is off. Round the cycle: from the last frame to the first, which lie beside each other.</source>
        <translation>返回：从两端传递回来，查看偏差有多大。绕周期一圈：从最后一帧到第一帧，两者彼此相邻。</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>第一帧</translation>
    </message>
    <message>
        <source>The surface is carried from here …</source>
        <translation>表面从这里开始传递…</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>最后一帧</translation>
    </message>
    <message>
        <source>… to here</source>
        <translation>…到这里</translation>
    </message>
    <message>
        <source>Topology</source>
        <translation>拓扑</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>to</source>
        <translation>至</translation>
    </message>
    <message>
        <source>Check over time</source>
        <translation>随时间的检查</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV…</translation>
    </message>
    <message>
        <source>Plot…</source>
        <translation>曲线图…</translation>
    </message>
    <message>
        <source>Save the curve as CSV</source>
        <translation>将曲线保存为 CSV</translation>
    </message>
    <message>
        <source>The same table as “handlebody-cli segment --curve F.csv” writes</source>
        <translation>与“handlebody-cli segment --curve F.csv”写出的表格相同</translation>
    </message>
    <message>
        <source>Save the curve as a plot</source>
        <translation>将曲线保存为图</translation>
    </message>
    <message>
        <source>The same picture (SVG) as “handlebody-cli segment --curve F.svg” writes</source>
        <translation>与“handlebody-cli segment --curve F.svg”写出的图 (SVG) 相同</translation>
    </message>
    <message>
        <source>Meshes…</source>
        <translation>网格…</translation>
    </message>
    <message>
        <source>Labels…</source>
        <translation>标签…</translation>
    </message>
    <message>
        <source>Save the volume over time</source>
        <translation>保存体积随时间的变化</translation>
    </message>
    <message>
        <source>End-diastole %1 (frame %2), end-systole %3 (frame %4), stroke volume %5, &lt;b&gt;ejection fraction %6 %&lt;/b&gt;.</source>
        <translation>舒张末期 %1（第 %2 帧），收缩末期 %3（第 %4 帧），每搏输出量 %5，&lt;b&gt;射血分数 %6 %&lt;/b&gt;。</translation>
    </message>
    <message>
        <source>From frame %1 back at frame %2: Dice %3, %4 off.</source>
        <translation>从第 %1 帧返回第 %2 帧：Dice %3，偏差 %4。</translation>
    </message>
    <message>
        <source>The surface was lost on its way from frame %1 back to frame %2.</source>
        <translation>表面在从第 %1 帧返回第 %2 帧的途中丢失。</translation>
    </message>
    <message>
        <source>Frame %1 is being corrected: change it with clicks, walls and edits, then carry on from there.</source>
        <translation>正在修正第 %1 帧：请用点击、屏障和编辑进行更改，然后由此继续传递。</translation>
    </message>
    <message>
        <source>Carrying the surface through the frames…</source>
        <translation>正在将表面传递到各帧…</translation>
    </message>
    <message>
        <source>These are of an earlier surface of frame %1: carry it anew.</source>
        <translation>这些来自第 %1 帧较早的表面：请重新传递。</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::RulersPage</name>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Delete the chosen ruler or angle</source>
        <translation>删除所选标尺或角度</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Begins at (LPS)</source>
        <translation>起点 (LPS)</translation>
    </message>
    <message>
        <source>Rulers and angles</source>
        <translation>标尺和角度</translation>
    </message>
    <message>
        <source>Places points in the slices or on the surface in 3D. Their ends can be dragged.</source>
        <translation>在切面或 3D 表面上放置点。端点可拖动。</translation>
    </message>
    <message>
        <source>Click where the ruler begins, or press Return for the crosshair.</source>
        <translation>点击标尺起点，或按回车使用十字线。</translation>
    </message>
    <message>
        <source>Click where it ends. Escape takes the beginning back.</source>
        <translation>点击终点。Esc 取消起点。</translation>
    </message>
    <message>
        <source>Click the end of one leg, or press Return for the crosshair.</source>
        <translation>点击一条边的端点，或按回车使用十字线。</translation>
    </message>
    <message>
        <source>Click where the legs meet. Escape takes the last point back.</source>
        <translation>点击两边的交点。Esc 取消上一点。</translation>
    </message>
    <message>
        <source>Click the end of the other leg. Escape takes the last point back.</source>
        <translation>点击另一条边的端点。Esc 取消上一点。</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>保存为 CSV…</translation>
    </message>
    <message>
        <source>Lengths in mm, angles in degrees and their points (mm, LPS) as a table</source>
        <translation>长度（mm）、角度（度）及其各点（mm，LPS）的表格</translation>
    </message>
    <message>
        <source>Save as JSON…</source>
        <translation>保存为 JSON…</translation>
    </message>
    <message>
        <source>The same as “handlebody-cli measure --json” writes of them</source>
        <translation>与“handlebody-cli measure --json”所写的相同</translation>
    </message>
    <message>
        <source>Save the rulers and angles</source>
        <translation>保存标尺和角度</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SectionPlot</name>
    <message>
        <source>Area and equivalent diameter along the centre line</source>
        <translation>沿中心线的面积和等效直径</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Area (mm²)</source>
        <translation>面积 (mm²)</translation>
    </message>
    <message>
        <source>Equivalent diameter (mm)</source>
        <translation>等效直径 (mm)</translation>
    </message>
    <message>
        <source>Area and equivalent diameter are plotted here along the line.</source>
        <translation>此处绘制沿线的面积和等效直径。</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SeedPanel</name>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Radius of the selected seed. Automatic: the largest ball that fits into the object; outside of it, as the image allows</source>
        <translation>所选种子点的半径。自动：能放入目标的最大球；目标外则视图像而定</translation>
    </message>
    <message>
        <source>%1 (auto)</source>
        <translation>%1（自动）</translation>
    </message>
    <message>
        <source>None yet: it takes a seed inside.</source>
        <translation>还没有：需要一个内部种子点。</translation>
    </message>
    <message>
        <source>Given by the range in step 3, Tune.</source>
        <translation>由第 3 步“调整”中的范围给定。</translation>
    </message>
    <message>
        <source>Looking for it…</source>
        <translation>正在寻找…</translation>
    </message>
    <message>
        <source>Click into the structure in any slice, then press Return: a ball is placed there, from which the surface grows. One seed is often enough. Shift+Return marks a place outside. Drag a seed to move it, its rim to resize it.</source>
        <translation>在任一切面点击结构内部，然后按回车：在那里放置一个球，表面由此生长。通常一个种子点即可。Shift+回车标记外部位置。拖动种子点可移动，拖动边缘可改变大小。</translation>
    </message>
    <message>
        <source>What is wrong with the seeds</source>
        <translation>种子点的问题</translation>
    </message>
    <message>
        <source>Centre (mm LPS)</source>
        <translation>中心 (mm LPS)</translation>
    </message>
    <message>
        <source>Radius (mm)</source>
        <translation>半径 (mm)</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Seeds</source>
        <translation>种子点</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>外部</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>内部</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SensitivityPage</name>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Volume (ml)</source>
        <translation>体积 (ml)</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>连通分量</translation>
    </message>
    <message>
        <source>Tunnels</source>
        <translation>隧道</translation>
    </message>
    <message>
        <source>Away (mm)</source>
        <translation>距离 (mm)</translation>
    </message>
    <message>
        <source>The perturbed runs</source>
        <translation>扰动运行</translation>
    </message>
    <message>
        <source>Save the perturbed runs</source>
        <translation>保存扰动运行</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>敏感性</translation>
    </message>
    <message>
        <source>Grow the surface several times again, with clicks, smoothing and noise a little different: how much do volume and surface change?</source>
        <translation>略微改变点击位置、平滑和噪声后多次重新生长表面：体积和表面会改变多少？</translation>
    </message>
    <message>
        <source> runs</source>
        <translation> 次运行</translation>
    </message>
    <message>
        <source>Number of runs</source>
        <translation>运行次数</translation>
    </message>
    <message>
        <source>How often it is grown again; each takes about as long as the growth</source>
        <translation>重新生长的次数；每次耗时与生长大致相同</translation>
    </message>
    <message>
        <source>Volume with its spread</source>
        <translation>体积及其离散程度</translation>
    </message>
    <message>
        <source>State of the sensitivity</source>
        <translation>敏感性的状态</translation>
    </message>
    <message>
        <source>How far it moves, in colour on the surface</source>
        <translation>在表面上以颜色显示移动距离</translation>
    </message>
    <message>
        <source>White where the surface is certain, red where it moves from run to run</source>
        <translation>白色表示表面确定，红色表示各次运行间有移动</translation>
    </message>
    <message>
        <source>How many runs have ended</source>
        <translation>已结束的运行次数</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>保存为 CSV…</translation>
    </message>
    <message>
        <source>Save the runs as CSV</source>
        <translation>将各次运行保存为 CSV</translation>
    </message>
    <message>
        <source>Volume, topology and distance of every run</source>
        <translation>每次运行的体积、拓扑和距离</translation>
    </message>
    <message>
        <source>moves by</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>%1 ± %2 ml</source>
        <translation>%1 ± %2 ml</translation>
    </message>
    <message>
        <source>%1 to %2 in %3 of %4 runs, %5 of the same topology. The surface moves by %6, 95 % of it by less than %7.</source>
        <translation>%4 次运行中有 %3 次得到 %1 至 %2，其中 %5 次拓扑相同。表面移动 %6，其 95 % 的部分小于 %7。</translation>
    </message>
    <message>
        <source> ⚠ %1.</source>
        <translation> ⚠ %1。</translation>
    </message>
    <message>
        <source>None of the runs left a surface.</source>
        <translation>没有一次运行留下表面。</translation>
    </message>
    <message>
        <source>Growing it again…</source>
        <translation>正在重新生长…</translation>
    </message>
    <message>
        <source>These are figures of an earlier surface, or of another object.</source>
        <translation>这些指标属于较早的表面或其他目标。</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SeriesList</name>
    <message>
        <source>, stack %1</source>
        <translation>，堆栈 %1</translation>
    </message>
    <message>
        <source>No volume: %1</source>
        <translation>无体数据：%1</translation>
    </message>
    <message>
        <source>%1, %2 mm</source>
        <translation>%1, %2 mm</translation>
    </message>
    <message>
        <source>Slices: %1</source>
        <translation>层数：%1</translation>
    </message>
    <message>
        <source>Files: %1</source>
        <translation>文件：%1</translation>
    </message>
    <message>
        <source> · time points: %1</source>
        <translation> · 时间点：%1</translation>
    </message>
    <message>
        <source>Series in the folder</source>
        <translation>文件夹中的序列</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SliceView</name>
    <message>
        <source>%1, oblique</source>
        <translation>%1，倾斜</translation>
    </message>
    <message>
        <source>W %1  L %2</source>
        <translation>窗宽 %1  窗位 %2</translation>
    </message>
    <message>
        <source>no edge in the image</source>
        <translation>图像无边缘</translation>
    </message>
    <message>
        <source>pinned</source>
        <translation>已固定</translation>
    </message>
    <message>
        <source>Open a volume: Ctrl+O,
or drop a file here</source>
        <translation>打开体数据：Ctrl+O，
或将文件拖到此处</translation>
    </message>
    <message>
        <source>%1 slice</source>
        <translation>%1切面</translation>
    </message>
    <message>
        <source>Arrows and Page Up or Down move the crosshair, Return adds a seed, Shift and Return a click outside of the object, W changes window and level. B and E turn the brush for walls on and off, with Shift they paint and erase at the crosshair; L pins with it, Shift and L unpins, M smooths, U pulls.</source>
        <translation>方向键和 Page Up/Down 移动十字线，回车添加种子点，Shift+回车添加外部点，W 调节窗宽窗位。B 和 E 开关屏障画笔，加 Shift 在十字线处绘制和擦除；L 固定，Shift+L 取消固定，M 平滑，U 拉动。</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SpacingEntry</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Distance between the middles of neighbouring voxels</source>
        <translation>相邻体素中心的距离</translation>
    </message>
    <message>
        <source>Size of a voxel</source>
        <translation>体素大小</translation>
    </message>
    <message>
        <source>The file does not give it. Lengths and volumes are right only with the true spacing along columns, rows and slices.</source>
        <translation>文件未给出。只有输入列、行和层的真实间距，长度和体积才正确。</translation>
    </message>
    <message>
        <source>Spacing of columns</source>
        <translation>列间距</translation>
    </message>
    <message>
        <source>Spacing of rows</source>
        <translation>行间距</translation>
    </message>
    <message>
        <source>Spacing of slices</source>
        <translation>层间距</translation>
    </message>
    <message>
        <source>Open with this spacing</source>
        <translation>以此间距打开</translation>
    </message>
    <message>
        <source>File without a spacing</source>
        <translation>没有间距的文件</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::StartPage</name>
    <message>
        <source>Open a volume to begin</source>
        <translation>打开体数据以开始</translation>
    </message>
    <message>
        <source>Drop a CT, MR or ultrasound volume here, or choose one.</source>
        <translation>将 CT、MR 或超声体数据拖到此处，或选择一个。</translation>
    </message>
    <message>
        <source>Try the ultrasound sample</source>
        <translation>试用超声示例</translation>
    </message>
    <message>
        <source>A simulated cyst with a needle through it, with its seed placed</source>
        <translation>模拟囊肿，有针穿过，已放置种子点</translation>
    </message>
    <message>
        <source>Opened before</source>
        <translation>曾打开</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>打开 %1</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::StatusFields</name>
    <message>
        <source>Position of the mouse, mm LPS</source>
        <translation>鼠标位置，mm LPS</translation>
    </message>
    <message>
        <source>Voxel under the mouse</source>
        <translation>鼠标下的体素</translation>
    </message>
    <message>
        <source>Voxel %1</source>
        <translation>体素 %1</translation>
    </message>
    <message>
        <source>Intensity of the voxel</source>
        <translation>体素强度</translation>
    </message>
    <message>
        <source>Intensity %1</source>
        <translation>强度 %1</translation>
    </message>
    <message>
        <source>Uncalibrated</source>
        <translation>未校准</translation>
    </message>
    <message>
        <source>State of the growth</source>
        <translation>生长状态</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Stop reading the volume; what is open stays open</source>
        <translation>停止读取体数据；已打开的保持不变</translation>
    </message>
    <message>
        <source>The file does not give the size of a voxel: lengths, areas and volumes mean nothing until it is entered in step 1, Open</source>
        <translation>文件未给出体素大小：在第 1 步“打开”中输入之前，长度、面积和体积没有意义</translation>
    </message>
    <message>
        <source>Nothing is open</source>
        <translation>未打开任何内容</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>正在读取 %1…</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::StepsPanel</name>
    <message>
        <source>Step %1</source>
        <translation>步骤 %1</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SurfaceView</name>
    <message>
        <source>This machine offers no OpenGL 3.2: the surface cannot be shown in 3D. Slices, growth and export work all the same.</source>
        <translation>本机不支持 OpenGL 3.2：无法以 3D 显示表面。切面、生长和导出仍可使用。</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>The surface grows here</source>
        <translation>表面在此生长</translation>
    </message>
    <message>
        <source>Nothing is left of the surface</source>
        <translation>表面已不存在</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D 视图</translation>
    </message>
    <message>
        <source>Home, End and Page Down look from superior, anterior and left. With the brush on, left pins, unpins, smooths or pulls the surface.</source>
        <translation>Home、End 和 Page Down 从上、前、左观察。启用画笔时，左键固定、取消固定、平滑或拉动表面。</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TimeBar</name>
    <message>
        <source>Frame %1 of 0–%2</source>
        <translation>第 %1 帧（0–%2）</translation>
    </message>
    <message>
        <source>%1, %2 ms</source>
        <translation>%1，%2 ms</translation>
    </message>
    <message>
        <source>Shown frame</source>
        <translation>所示帧</translation>
    </message>
    <message>
        <source>What is wrong with the shown frame</source>
        <translation>所示帧的问题</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>正在读取…</translation>
    </message>
    <message>
        <source>The surface is grown in this frame</source>
        <translation>表面在此帧中生长</translation>
    </message>
    <message>
        <source>The surface has not been carried here</source>
        <translation>表面尚未传递到这里</translation>
    </message>
    <message>
        <source>The surface here was carried from an earlier state of frame %1: carry it again.</source>
        <translation>此处的表面是从帧 %1 的较早状态传递而来的：请重新传递。</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TimelinePanel</name>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Changes of topology are listed here.</source>
        <translation>此处列出拓扑变化。</translation>
    </message>
    <message>
        <source>Show repairs of the mesh, too</source>
        <translation>也显示网格修复</translation>
    </message>
    <message>
        <source>&lt;p&gt;Folds that were smoothed away, and parts of the surface whose step would have left an invalid mesh and that returned to where they were. The topology is the same before and after.&lt;/p&gt;</source>
        <translation>&lt;p&gt;已平滑的褶皱，以及因会产生无效网格而退回原位的表面部分。前后拓扑相同。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TimelinePlot</name>
    <message>
        <source>Leak: %1</source>
        <translation>泄漏：%1</translation>
    </message>
    <message>
        <source>Volume and moving share over the iterations</source>
        <translation>体积和移动比例随迭代的变化</translation>
    </message>
    <message>
        <source>Iteration %1: %2, %3 % of the vertices moving, %4</source>
        <translation>第 %1 次迭代：%2，%3 % 的顶点移动，%4</translation>
    </message>
    <message>
        <source>events: %1</source>
        <translation>事件：%1</translation>
    </message>
    <message>
        <source>Volume, up to %1</source>
        <translation>体积，至 %1</translation>
    </message>
    <message>
        <source>Moving, 0 to 100 %</source>
        <translation>移动，0 至 100 %</translation>
    </message>
    <message>
        <source>Volume and motion are plotted here while the surface grows.</source>
        <translation>表面生长时在此绘制体积和移动。</translation>
    </message>
    <message>
        <source>Changed at %1: %2</source>
        <translation>在 %1 处更改：%2</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TimelineSlider</name>
    <message>
        <source>Iteration</source>
        <translation>迭代</translation>
    </message>
    <message>
        <source>&lt;p&gt;Iterations; diamonds are changes of topology, strokes below the line places that were rolled back. Click or drag to go there.&lt;/p&gt;</source>
        <translation>&lt;p&gt;迭代；菱形为拓扑变化，线下的短线为被撤回的位置。点击或拖动以到达。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TopologySection</name>
    <message>
        <source>Held at iteration %1: %2.</source>
        <translation>第 %1 次迭代时被阻止：%2。</translation>
    </message>
    <message>
        <source>any</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>Topology</source>
        <translation>拓扑</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Never more than</source>
        <translation>不超过</translation>
    </message>
    <message>
        <source>Ask each time</source>
        <translation>每次询问</translation>
    </message>
    <message>
        <source>What happens where the surface would get more parts or tunnels than are chosen: it gets them, never does (what is held is listed in Correct), or the growth pauses and asks you</source>
        <translation>当表面的部分或隧道将多于所选数目时如何处理：允许，始终不允许（被阻止的列在“修正”中），或暂停生长并询问您</translation>
    </message>
    <message>
        <source>Components at most</source>
        <translation>连通分量上限</translation>
    </message>
    <message>
        <source>Connected parts of the surface, cavities included</source>
        <translation>表面的连通部分，包括空腔</translation>
    </message>
    <message>
        <source>Genus at most</source>
        <translation>亏格上限</translation>
    </message>
    <message>
        <source>Tunnels, as in a ring, of all parts together</source>
        <translation>所有部分合计的隧道（如环中的孔）</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>部分</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>亏格</translation>
    </message>
    <message>
        <source>To decide</source>
        <translation>待决定</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>允许发生</translation>
    </message>
    <message>
        <source>It may break the limits here; the growth goes on</source>
        <translation>此处可以超出限制；生长继续</translation>
    </message>
    <message>
        <source>Hold it</source>
        <translation>阻止</translation>
    </message>
    <message>
        <source>It stays held here, and you are not asked again; the growth goes on</source>
        <translation>此处继续阻止，且不再询问您；生长继续</translation>
    </message>
    <message>
        <source>Free topology</source>
        <translation>不限制拓扑</translation>
    </message>
    <message>
        <source>Ask about the topology</source>
        <translation>询问拓扑变化</translation>
    </message>
    <message>
        <source>Limit the topology</source>
        <translation>限制拓扑</translation>
    </message>
    <message>
        <source>%1 more to decide.</source>
        <translation>还有 %1 项待决定。</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TouchSection</name>
    <message>
        <source>Pin</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>取消固定</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>拉动</translation>
    </message>
    <message>
        <source>Cut line</source>
        <translation>沿线切割</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Number of pins</source>
        <translation>固定数</translation>
    </message>
    <message>
        <source>Nothing is pinned.</source>
        <translation>没有固定。</translation>
    </message>
    <message>
        <source>Balls pinned: %1</source>
        <translation>固定的球：%1</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TunePanel</name>
    <message>
        <source>What is wrong with the parameters</source>
        <translation>参数的问题</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>暗</translation>
    </message>
    <message>
        <source>Bright</source>
        <translation>亮</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>The object is darker than its surroundings</source>
        <translation>目标比周围暗</translation>
    </message>
    <message>
        <source>The object is brighter than its surroundings</source>
        <translation>目标比周围亮</translation>
    </message>
    <message>
        <source>Found out from the image around the seeds</source>
        <translation>由种子点周围的图像确定</translation>
    </message>
    <message>
        <source>Change object</source>
        <translation>更改目标</translation>
    </message>
    <message>
        <source>Intensities from the lower to the upper end belong to the object</source>
        <translation>下限到上限之间的强度属于目标</translation>
    </message>
    <message>
        <source>Intensities of the object</source>
        <translation>目标强度</translation>
    </message>
    <message>
        <source>Lowest intensity of the object</source>
        <translation>目标最低强度</translation>
    </message>
    <message>
        <source>Highest intensity of the object</source>
        <translation>目标最高强度</translation>
    </message>
    <message>
        <source>Range: automatic</source>
        <translation>范围：自动</translation>
    </message>
    <message>
        <source>Chosen from the image around the seeds</source>
        <translation>由种子点周围的图像选取</translation>
    </message>
    <message>
        <source>to</source>
        <translation>至</translation>
    </message>
    <message>
        <source>Change range</source>
        <translation>更改范围</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>Change smoothing</source>
        <translation>更改平滑</translation>
    </message>
    <message>
        <source>Change edge length</source>
        <translation>更改边长</translation>
    </message>
    <message>
        <source>Change balloon</source>
        <translation>更改气球力</translation>
    </message>
    <message>
        <source>Change curvature</source>
        <translation>更改曲率</translation>
    </message>
    <message>
        <source>Change iteration limit</source>
        <translation>更改迭代上限</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Outward</source>
        <translation>仅向外</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>两侧</translation>
    </message>
    <message>
        <source>The surface only grows</source>
        <translation>表面只生长</translation>
    </message>
    <message>
        <source>The surface may also shrink</source>
        <translation>表面也可收缩</translation>
    </message>
    <message>
        <source>Change direction</source>
        <translation>更改方向</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>专家</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>碰撞</translation>
    </message>
    <message>
        <source>Sorted</source>
        <translation>排序</translation>
    </message>
    <message>
        <source>Hashing</source>
        <translation>散列</translation>
    </message>
    <message>
        <source>Near vertices are found in one sorted table. The surface does not depend on it</source>
        <translation>在一张排序表中查找邻近顶点。不影响表面</translation>
    </message>
    <message>
        <source>Near vertices are found by the paper's eight hash functions: slower, the same surface</source>
        <translation>用论文中的八个散列函数查找邻近顶点：较慢，表面相同</translation>
    </message>
    <message>
        <source>Change search for collisions</source>
        <translation>更改碰撞搜索</translation>
    </message>
    <message>
        <source>%1 everything here is then chosen from the image. Change it only if the surface leaks or stops early.</source>
        <translation>%1此处的一切将由图像自动选取。仅当表面泄漏或过早停止时才更改。</translation>
    </message>
    <message>
        <source>Place a seed:</source>
        <translation>放置种子点：</translation>
    </message>
    <message>
        <source>Open a volume and place a seed:</source>
        <translation>打开体数据并放置种子点：</translation>
    </message>
    <message>
        <source>Auto (dark)</source>
        <translation>自动（暗）</translation>
    </message>
    <message>
        <source>Auto (bright)</source>
        <translation>自动（亮）</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>边</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>均匀</translation>
    </message>
    <message>
        <source>Adaptive</source>
        <translation>自适应</translation>
    </message>
    <message>
        <source>The target edge length is the same everywhere</source>
        <translation>目标边长处处相同</translation>
    </message>
    <message>
        <source>Edges and steps are up to four times as long where the image shows no boundary near by: fewer iterations</source>
        <translation>图像附近没有边界之处，边和步长最多为四倍：迭代更少</translation>
    </message>
    <message>
        <source>Change edges</source>
        <translation>更改边</translation>
    </message>
    <message>
        <source>Tint the object in the slices</source>
        <translation>在切面中着色目标</translation>
    </message>
    <message>
        <source>The voxels that the surface is driven into: as smoothed, up to necks that are cut and to walls. They are tinted for a moment after every change; with this on, all the time</source>
        <translation>曲面将进入的体素：平滑后的，止于被切断的狭窄处和壁。每次更改后短暂着色；勾选后始终着色</translation>
    </message>
    <message>
        <source>Adaptive where the object is wide for its edges, so that this saves iterations</source>
        <translation>当对象相对于边长足够宽、可减少迭代时使用自适应</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TunnelsList</name>
    <message>
        <source>Component removed</source>
        <translation>移除连通分量</translation>
    </message>
    <message>
        <source>One component kept</source>
        <translation>保留一个连通分量</translation>
    </message>
    <message>
        <source>Cavity filled</source>
        <translation>填充空腔</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>已平滑</translation>
    </message>
    <message>
        <source>Pulled</source>
        <translation>已拉动</translation>
    </message>
    <message>
        <source>Cut by a plane</source>
        <translation>平面切割</translation>
    </message>
    <message>
        <source>Handle cut</source>
        <translation>切断环柄</translation>
    </message>
    <message>
        <source>Tunnel filled</source>
        <translation>隧道已填充</translation>
    </message>
    <message>
        <source>Tunnel closed</source>
        <translation>隧道闭合</translation>
    </message>
    <message>
        <source>What the surface holds</source>
        <translation>表面的内容</translation>
    </message>
    <message>
        <source>The chosen row</source>
        <translation>所选行</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Tunnels, components and cavities, each with its size</source>
        <translation>隧道、连通分量和空腔及其大小</translation>
    </message>
    <message>
        <source>Cut handle</source>
        <translation>切断环柄</translation>
    </message>
    <message>
        <source>Cuts along the loop around the handle, which goes; both ends get a cap</source>
        <translation>沿绕环柄的环切割，环柄消失；两端加盖</translation>
    </message>
    <message>
        <source>Fill tunnel</source>
        <translation>填充隧道</translation>
    </message>
    <message>
        <source>Cuts along the loop round the tunnel: a membrane closes it on both sides</source>
        <translation>沿绕隧道的环切割：膜从两侧封闭隧道</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Removes this component with all that lies in it</source>
        <translation>移除该连通分量及其内部的一切</translation>
    </message>
    <message>
        <source>Keep only this</source>
        <translation>仅保留此项</translation>
    </message>
    <message>
        <source>Removes everything but this component and its cavities</source>
        <translation>移除除该连通分量及其空腔外的一切</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>填充</translation>
    </message>
    <message>
        <source>Fills this cavity, with all that lies in it</source>
        <translation>填充该空腔及其内部的一切</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>略去</translation>
    </message>
    <message>
        <source>Goes back to the step before this edit, and on without it</source>
        <translation>退回到此编辑之前的一步并不经它继续</translation>
    </message>
    <message>
        <source>Tunnel</source>
        <translation>隧道</translation>
    </message>
    <message>
        <source>%1 around its handle, %2 round the tunnel</source>
        <translation>绕环柄 %1，绕隧道 %2</translation>
    </message>
    <message>
        <source>; knotted</source>
        <translation>；打结</translation>
    </message>
    <message>
        <source>Cavity</source>
        <translation>空腔</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>连通分量</translation>
    </message>
    <message>
        <source>%1 mm, genus %2</source>
        <translation>%1 mm，亏格 %2</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>第 %1 步</translation>
    </message>
    <message>
        <source>At %1</source>
        <translation>位于 %1</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>正在寻找…</translation>
    </message>
    <message>
        <source>Tunnels: %1</source>
        <translation>隧道：%1</translation>
    </message>
    <message>
        <source>components: %1</source>
        <translation>连通分量：%1</translation>
    </message>
    <message>
        <source>cavities: %1</source>
        <translation>空腔：%1</translation>
    </message>
    <message>
        <source>tunnels without loops: %1</source>
        <translation>无环隧道：%1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Find tunnels and pieces</source>
        <translation>查找隧道和部分</translation>
    </message>
    <message>
        <source>Lists the tunnels, components and cavities of the shown surface</source>
        <translation>列出所示表面的隧道、连通分量和空腔</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ValueField</name>
    <message>
        <source>Reset %1</source>
        <translation>重置%1</translation>
    </message>
    <message>
        <source>Back to the usual value, %1</source>
        <translation>恢复常用值 %1</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>%1: automatic</source>
        <translation>%1：自动</translation>
    </message>
    <message>
        <source>The value is chosen from the image around the seeds</source>
        <translation>该值由种子点周围的图像选取</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ViewFrame</name>
    <message>
        <source>Show all four views (double click)</source>
        <translation>显示全部四个视图（双击）</translation>
    </message>
    <message>
        <source>Let this view fill the window (double click)</source>
        <translation>此视图铺满窗口（双击）</translation>
    </message>
    <message>
        <source>Show all four views</source>
        <translation>显示全部四个视图</translation>
    </message>
    <message>
        <source>Maximise the %1 view</source>
        <translation>最大化%1视图</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ViewGrid</name>
    <message>
        <source>Axial</source>
        <translation>轴位</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>冠状位</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>矢状位</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>%1 view</source>
        <translation>%1视图</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::VolumePlot</name>
    <message>
        <source>Volume over time</source>
        <translation>体积随时间变化</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Volume (ml) over time (ms)</source>
        <translation>体积 (ml) 随时间 (ms) 的变化</translation>
    </message>
    <message>
        <source>Volume (ml) over frames</source>
        <translation>体积 (ml) 随帧的变化</translation>
    </message>
    <message>
        <source>end-diastole</source>
        <translation>舒张末期</translation>
    </message>
    <message>
        <source>end-systole</source>
        <translation>收缩末期</translation>
    </message>
    <message>
        <source>The volume over time is plotted here when the surface is carried through the frames.</source>
        <translation>将表面传递到各帧后，此处绘制体积随时间的变化。</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::WallSection</name>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Number of walls</source>
        <translation>屏障数</translation>
    </message>
    <message>
        <source>Nothing is painted.</source>
        <translation>没有绘制。</translation>
    </message>
    <message>
        <source>Balls painted: %1</source>
        <translation>绘制的球：%1</translation>
    </message>
</context>
</TS>
