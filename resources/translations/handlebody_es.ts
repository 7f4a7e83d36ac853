<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es_ES" sourcelanguage="en">
<context>
    <name>Findings</name>
    <message>
        <source>the surface is held at a neck of radius {radius_mm:3g} mm: behind it the same intensities go on for at least {behind_ml:3g} ml, in front of it they fill {in_front_ml:3g} ml; where that belongs to the object, put a seed there too, or set the range in step 3, Tune, which holds nothing back</source>
        <translation>la superficie queda retenida en un estrechamiento de {radius_mm:3g} mm de radio: detrás, las mismas intensidades continúan al menos {behind_ml:3g} ml, delante llenan {in_front_ml:3g} ml; si eso pertenece al objeto, ponga también allí una semilla o fije el intervalo en el paso 3, Ajustar, que no retiene nada</translation>
    </message>
    <message>
        <source>the surface is held at a hole of radius {radius_mm:3g} mm in a thin wall: behind it the same intensities go on for at least {behind_ml:3g} ml, in front of it they fill {in_front_ml:3g} ml; where that belongs to the object, put a seed there too, or set the range in step 3, Tune, which holds nothing back</source>
        <translation>la superficie queda retenida en un agujero de {radius_mm:3g} mm de radio en una pared fina: detrás, las mismas intensidades continúan al menos {behind_ml:3g} ml, delante llenan {in_front_ml:3g} ml; si eso pertenece al objeto, ponga también allí una semilla o fije el intervalo en el paso 3, Ajustar, que no retiene nada</translation>
    </message>
    <message>
        <source>the surface is held where its structure grows wider than a radius of {radius_mm:3g} mm: behind it the same intensities go on for at least {behind_ml:3g} ml, in front of it they fill {in_front_ml:3g} ml; where that belongs to the object, put a seed there too, or set the range in step 3, Tune, which holds nothing back</source>
        <translation>la superficie queda retenida donde su estructura supera {radius_mm:3g} mm de radio: detrás, las mismas intensidades continúan al menos {behind_ml:3g} ml, delante llenan {in_front_ml:3g} ml; si eso pertenece al objeto, ponga también allí una semilla o fije el intervalo en el paso 3, Ajustar, que no retiene nada</translation>
    </message>
    <message>
        <source>the surface got stuck: no part of a step could be kept, again and again; another edge length may help</source>
        <translation>la superficie está bloqueada: una y otra vez no se pudo conservar ninguna parte de un paso; otra longitud de arista puede ayudar</translation>
    </message>
    <message>
        <source>the surface rests at places that would still move, because changes there failed or repeated again and again; another edge length or smoothing may help</source>
        <translation>la superficie reposa en lugares que aún se moverían, porque allí los cambios fallaron o se repitieron una y otra vez; otra longitud de arista u otro suavizado puede ayudar</translation>
    </message>
    <message>
        <source>the surface hardly grew beyond its seed: look at the kind of object and the range in step 3, Tune</source>
        <translation>la superficie apenas creció más allá de su semilla: revise el tipo de objeto y el intervalo en el paso 3, Ajustar</translation>
    </message>
    <message>
        <source>the surface hardly grew beyond its seed: the curvature weight holds every front of a radius below {radius_mm:3g} mm, and the seed is smaller; give it a larger radius, or lower the weight</source>
        <translation>la superficie apenas creció más allá de su semilla: el peso de la curvatura retiene todo frente de radio inferior a {radius_mm:3g} mm, y la semilla es menor; dele un radio mayor o reduzca el peso</translation>
    </message>
    <message>
        <source>the choice among {objects} objects is close (expected overlap with the one that is meant: Dice {dice:2g}): the next candidate holds {next_ml:3m} ml where this one holds {this_ml:3m} ml; another one can be chosen in step 2, Seed</source>
        <translation>la elección entre {objects} objetos es ajustada (solapamiento esperado con el que se busca: Dice {dice:2g}): el siguiente candidato contiene {next_ml:3m} ml y este {this_ml:3m} ml; se puede elegir otro en el paso 2, Semillas</translation>
    </message>
    <message>
        <source>the surface leaked at iteration {iteration}: {cause}</source>
        <translation>la superficie se fugó en la iteración {iteration}: {cause}</translation>
    </message>
    <message>
        <source>the surface leaked at iteration {iteration}: {cause}; a wall was put there</source>
        <translation>la superficie se fugó en la iteración {iteration}: {cause}; allí se puso una barrera</translation>
    </message>
    <message>
        <source>the surface leaked at iteration {iteration}: {cause}; the mesh is that of iteration {mesh_iteration}, before it came there</source>
        <translation>la superficie se fugó en la iteración {iteration}: {cause}; la malla es la de la iteración {mesh_iteration}, antes de llegar allí</translation>
    </message>
    <message>
        <source>The seed is not in an object with a boundary of its own: what grows from it fills the field of view, up to the padding around the image. Where that is meant, say whether it is dark or bright, or set the range in step 3, Tune.</source>
        <translation>La semilla no está en un objeto con borde propio: lo que crece de ella llena el campo de visión hasta el relleno alrededor de la imagen. Si es lo deseado, indique si es oscuro o claro, o fije el intervalo en el paso 3, Ajustar.</translation>
    </message>
    <message>
        <source>The seed at {place:1f} mm lies outside the volume.</source>
        <translation>La semilla en {place:1f} mm está fuera del volumen.</translation>
    </message>
    <message>
        <source>The click outside of the object at {place:1f} mm lies outside the volume.</source>
        <translation>El punto exterior en {place:1f} mm está fuera del volumen.</translation>
    </message>
    <message>
        <source>The seed at {place:1f} mm is not in the object: the smoothed intensity there is {intensity:4g}, the object's range is {low:4g} to {high:4g}.</source>
        <translation>La semilla en {place:1f} mm no está en el objeto: la intensidad suavizada allí es {intensity:4g}, el intervalo del objeto va de {low:4g} a {high:4g}.</translation>
    </message>
    <message>
        <source>The range {low:4g} to {high:4g} holds no voxel of the volume, whose values run from {least:4g} to {most:4g}.</source>
        <translation>El intervalo de {low:4g} a {high:4g} no contiene ningún vóxel del volumen, cuyos valores van de {least:4g} a {most:4g}.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>{percent:0f} % of the surface lies where the image shows no edge: the object may go on there, or the surface leaked</source>
        <translation>el {percent:0f} % de la superficie está donde la imagen no muestra ningún borde: quizá el objeto continúe allí, o la superficie se fugó</translation>
    </message>
    <message>
        <source>{percent:0f} % of the surface lies on the border of the volume: the object is cut off there, or the surface leaked</source>
        <translation>el {percent:0f} % de la superficie está en el borde del volumen: el objeto queda cortado allí, o la superficie se fugó</translation>
    </message>
    <message>
        <source>{percent:0f} % of the surface lies on the border of the field of view: the object is cut off there, or the surface leaked</source>
        <translation>el {percent:0f} % de la superficie está en el borde del campo de visión: el objeto queda cortado allí, o la superficie se fugó</translation>
    </message>
    <message>
        <source>the surface still lies in a wall that was put over it</source>
        <translation>la superficie aún está en una barrera que se puso sobre ella</translation>
    </message>
    <message>
        <source>at the allowed place {place} nothing came that a limit of the topology would have held</source>
        <translation>en el lugar permitido {place} no llegó nada que un límite de la topología hubiera retenido</translation>
    </message>
    <message>
        <source>the surface is held at passages narrower than a radius of {radius_mm:3g} mm; where what lies behind them belongs to the object, put a seed there too, or take a larger candidate</source>
        <translation>la superficie queda retenida en pasos de menos de {radius_mm:3g} mm de radio; si lo que hay detrás pertenece al objeto, ponga también allí una semilla o tome un candidato mayor</translation>
    </message>
    <message>
        <source>the object reaches the end of what was searched around the seed and is cut off there; where it goes on, put a seed there too</source>
        <translation>el objeto llega al final de lo que se buscó alrededor de la semilla y queda cortado allí; donde continúe, ponga también una semilla</translation>
    </message>
    <message>
        <source>it came through a passage {width_mm:1f} mm wide at {place:1f} from a space {before_mm:0f} mm wide into one {behind_mm:0f} mm wide</source>
        <translation>pasó por un paso de {width_mm:1f} mm de ancho en {place:1f}, de un espacio de {before_mm:0f} mm a uno de {behind_mm:0f} mm</translation>
    </message>
    <message>
        <source>it came through a passage too narrow for the voxels to show at {place:1f} from a space {before_mm:0f} mm wide into one {behind_mm:0f} mm wide</source>
        <translation>pasó en {place:1f} por un paso demasiado estrecho para los vóxeles, de un espacio de {before_mm:0f} mm a uno de {behind_mm:0f} mm</translation>
    </message>
    <message>
        <source>the pin {pin} holds nothing: the mesh is that of iteration {mesh_iteration}, and its iteration never came</source>
        <translation>la fijación {pin} no sujeta nada: la malla es la de la iteración {mesh_iteration}, y su iteración nunca llegó</translation>
    </message>
    <message>
        <source>With clicks, smoothing and noise a little different, {runs} of {of} runs leave no surface</source>
        <translation>Con puntos, suavizado y ruido algo distintos, {runs} de {of} ejecuciones no dejan ninguna superficie</translation>
    </message>
    <message>
        <source>With clicks, smoothing and noise a little different, {runs} of {of} runs have another topology</source>
        <translation>Con puntos, suavizado y ruido algo distintos, {runs} de {of} ejecuciones tienen otra topología</translation>
    </message>
    <message>
        <source>The volume depends on where exactly is clicked, on smoothing or noise: it changes by {percent:0f} %</source>
        <translation>El volumen depende de dónde se hace clic exactamente, del suavizado o del ruido: varía un {percent:0f} %</translation>
    </message>
    <message>
        <source>The surface was made with an earlier one of the object '{object}', and a replay may make another</source>
        <translation>La superficie se hizo con una anterior del objeto «{object}», y una repetición puede dar otra</translation>
    </message>
    <message>
        <source>kept apart here, as asked</source>
        <translation>mantenido separado aquí, como se pidió</translation>
    </message>
    <message>
        <source>held: it would break the limit of the topology</source>
        <translation>retenido: superaría el límite de la topología</translation>
    </message>
    <message>
        <source>the same place changed again and again, and rests from now on</source>
        <translation>el mismo lugar cambió una y otra vez y desde ahora reposa</translation>
    </message>
    <message>
        <source>no part of the step could be kept</source>
        <translation>no se pudo conservar ninguna parte del paso</translation>
    </message>
    <message>
        <source>{fronts} fronts could not be joined at once: {cause}</source>
        <translation>{fronts} frentes no se pudieron unir a la vez: {cause}</translation>
    </message>
    <message>
        <source>of {fronts} fronts {left} left for the next round</source>
        <translation>de {fronts} frentes, {left} quedan para la ronda siguiente</translation>
    </message>
    <message>
        <source>1 ring added: {cause}</source>
        <translation>1 anillo añadido: {cause}</translation>
    </message>
    <message>
        <source>{rings} rings added: {cause}</source>
        <translation>{rings} anillos añadidos: {cause}</translation>
    </message>
    <message>
        <source>there may be a shorter handle</source>
        <translation>puede haber un asa más corta</translation>
    </message>
    <message>
        <source>the surface came to a pinned part, and stops before it</source>
        <translation>la superficie llegó a una parte fijada y se detiene ante ella</translation>
    </message>
    <message>
        <source>to close the place would take too much work</source>
        <translation>cerrar el lugar exigiría demasiado trabajo</translation>
    </message>
    <message>
        <source>the work that a step may take is done: the place waits</source>
        <translation>el trabajo permitido a un paso está hecho: el lugar espera</translation>
    </message>
    <message>
        <source>the fronts meet through the inside of the object</source>
        <translation>los frentes se encuentran a través del interior del objeto</translation>
    </message>
    <message>
        <source>no handle fits</source>
        <translation>ningún asa encaja</translation>
    </message>
    <message>
        <source>no patch fits</source>
        <translation>ningún parche encaja</translation>
    </message>
    <message>
        <source>the component encloses a place where no surface may go</source>
        <translation>el componente encierra un lugar adonde no puede ir ninguna superficie</translation>
    </message>
    <message>
        <source>the opening is too large</source>
        <translation>la abertura es demasiado grande</translation>
    </message>
    <message>
        <source>a pinned part lies there</source>
        <translation>allí hay una parte fijada</translation>
    </message>
    <message>
        <source>nothing of the component would be left</source>
        <translation>no quedaría nada del componente</translation>
    </message>
    <message>
        <source>the surface would have entered a wall</source>
        <translation>la superficie habría entrado en una barrera</translation>
    </message>
    <message>
        <source>a part of the surface has changed that detection had not looked at</source>
        <translation>cambió una parte de la superficie que la detección no había examinado</translation>
    </message>
    <message>
        <source>the events of the step do not follow from each other</source>
        <translation>los eventos del paso no se siguen unos de otros</translation>
    </message>
    <message>
        <source>the Euler number is not the one that the events predict</source>
        <translation>el número de Euler no es el que predicen los eventos</translation>
    </message>
    <message>
        <source>the components are not those that the events predict</source>
        <translation>los componentes no son los que predicen los eventos</translation>
    </message>
    <message>
        <source>a cavity lies outside of any body</source>
        <translation>una cavidad está fuera de todo cuerpo</translation>
    </message>
    <message>
        <source>a body lies directly in another</source>
        <translation>un cuerpo está directamente dentro de otro</translation>
    </message>
    <message>
        <source>the surface still intersected itself after several changes</source>
        <translation>la superficie aún se cortaba a sí misma tras varios cambios</translation>
    </message>
    <message>
        <source>the surface does not enclose a volume</source>
        <translation>la superficie no encierra ningún volumen</translation>
    </message>
    <message>
        <source>the surface would close over a pinned part, and stops before it</source>
        <translation>la superficie se cerraría sobre una parte fijada y se detiene antes</translation>
    </message>
    <message>
        <source>a pinned part would have changed</source>
        <translation>una parte fijada habría cambiado</translation>
    </message>
    <message>
        <source>the surface would come into a wall or around it</source>
        <translation>la superficie entraría en una barrera o la rodearía</translation>
    </message>
    <message>
        <source>a pinned part would change</source>
        <translation>una parte fijada cambiaría</translation>
    </message>
    <message>
        <source>there would be more components than may be</source>
        <translation>habría más componentes de los permitidos</translation>
    </message>
    <message>
        <source>there would be more tunnels than may be</source>
        <translation>habría más túneles de los permitidos</translation>
    </message>
    <message>
        <source>an edge has only one face</source>
        <translation>una arista tiene una sola cara</translation>
    </message>
    <message>
        <source>two faces disagree about their common edge</source>
        <translation>dos caras discrepan sobre su arista común</translation>
    </message>
    <message>
        <source>the two faces of an edge run in the same direction or have other ends</source>
        <translation>las dos caras de una arista van en el mismo sentido o tienen otros extremos</translation>
    </message>
    <message>
        <source>two faces have the same three vertices</source>
        <translation>dos caras tienen los mismos tres vértices</translation>
    </message>
    <message>
        <source>a face has a vertex that was removed</source>
        <translation>una cara tiene un vértice que fue eliminado</translation>
    </message>
    <message>
        <source>a face has a vertex twice</source>
        <translation>una cara tiene un vértice dos veces</translation>
    </message>
    <message>
        <source>a vertex has no face</source>
        <translation>un vértice no tiene cara</translation>
    </message>
    <message>
        <source>a vertex names a half-edge that does not leave it</source>
        <translation>un vértice nombra una semiarista que no sale de él</translation>
    </message>
    <message>
        <source>two edges join the same two vertices</source>
        <translation>dos aristas unen los mismos dos vértices</translation>
    </message>
    <message>
        <source>the faces around a vertex form more than one fan</source>
        <translation>las caras alrededor de un vértice forman más de un abanico</translation>
    </message>
    <message>
        <source>the counts of the mesh are not those of its elements</source>
        <translation>los recuentos de la malla no son los de sus elementos</translation>
    </message>
    <message>
        <source>no vertex of the surface lies in the ball</source>
        <translation>ningún vértice de la superficie está en la bola</translation>
    </message>
    <message>
        <source>the plane does not meet the surface</source>
        <translation>el plano no corta la superficie</translation>
    </message>
    <message>
        <source>the plane does not meet the surface near that place</source>
        <translation>el plano no corta la superficie cerca de ese lugar</translation>
    </message>
    <message>
        <source>no flat cap fits the cut</source>
        <translation>ninguna tapa plana encaja en el corte</translation>
    </message>
    <message>
        <source>the cut does not part the body there: both of its sides hang together</source>
        <translation>el corte no separa el cuerpo allí: sus dos lados están unidos</translation>
    </message>
    <message>
        <source>the pull goes too far for its radius</source>
        <translation>el tirón va demasiado lejos para su radio</translation>
    </message>
    <message>
        <source>nothing of the surface would be left</source>
        <translation>no quedaría nada de la superficie</translation>
    </message>
    <message>
        <source>the surface would meet itself there</source>
        <translation>la superficie se encontraría allí consigo misma</translation>
    </message>
    <message>
        <source>No seed was given: at least one is needed.</source>
        <translation>No se dio ninguna semilla: hace falta al menos una.</translation>
    </message>
    <message>
        <source>The radius of a seed must be a number of mm above 0.</source>
        <translation>El radio de una semilla debe ser un número de mm mayor que 0.</translation>
    </message>
    <message>
        <source>The seed is not in a dark object: the image has no clear boundary of that kind around it.</source>
        <translation>La semilla no está en un objeto oscuro: la imagen no tiene a su alrededor un borde claro de ese tipo.</translation>
    </message>
    <message>
        <source>The seed is not in a bright object: the image has no clear boundary of that kind around it.</source>
        <translation>La semilla no está en un objeto claro: la imagen no tiene a su alrededor un borde claro de ese tipo.</translation>
    </message>
    <message>
        <source>The seed is not in a dark or bright object: the image has no clear boundary of that kind around it.</source>
        <translation>La semilla no está en un objeto oscuro o claro: la imagen no tiene a su alrededor un borde claro de ese tipo.</translation>
    </message>
    <message>
        <source>The range is empty: its lower end is above its upper end.</source>
        <translation>El intervalo está vacío: su extremo inferior está por encima del superior.</translation>
    </message>
    <message>
        <source>Clicks outside of the object and a given range do not go together: the range alone says where the object ends.</source>
        <translation>Los puntos exteriores y un intervalo dado no van juntos: solo el intervalo dice dónde acaba el objeto.</translation>
    </message>
    <message>
        <source>The edge length of {edge_mm} mm is too short for the seeds: their surface alone would have over two million triangles.</source>
        <translation>La longitud de arista de {edge_mm} mm es demasiado corta para las semillas: solo su superficie tendría más de dos millones de triángulos.</translation>
    </message>
    <message>
        <source>The seed at {place} mm lies in the object '{object}', which is done already.</source>
        <translation>La semilla en {place} mm está en el objeto «{object}», que ya está terminado.</translation>
    </message>
    <message>
        <source>A wall lies over the seed at {place} mm.</source>
        <translation>Una barrera cubre la semilla en {place} mm.</translation>
    </message>
    <message>
        <source>A wall leaves the seed at {place} mm no room.</source>
        <translation>Una barrera no deja sitio a la semilla en {place} mm.</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies within the surface, which cannot be pushed out of it: go back to before it came in there.</source>
        <translation>La barrera en {place} mm está dentro de la superficie, que no puede ser empujada fuera: vuelva a antes de que llegara allí.</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies across surface that is already there: go back to before it came in there.</source>
        <translation>La barrera en {place} mm atraviesa superficie que ya está allí: vuelva a antes de que llegara.</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies over surface that is already there: go back to before it came in there, or let the surface move in both directions.</source>
        <translation>La barrera en {place} mm está sobre superficie que ya está allí: vuelva a antes de que llegara, o deje que la superficie se mueva en ambos sentidos.</translation>
    </message>
    <message>
        <source>The object '{object}' lies over surface that is already there: go back to before it came in there.</source>
        <translation>El objeto «{object}» está sobre superficie que ya está allí: vuelva a antes de que llegara.</translation>
    </message>
    <message>
        <source>The clicks have so little in common with the surface that it would begin anew, but a part of it is pinned: take the pins away first.</source>
        <translation>Los puntos tienen tan poco en común con la superficie que empezaría de nuevo, pero una parte está fijada: quite antes las fijaciones.</translation>
    </message>
    <message>
        <source>The veto of iteration {iteration} comes too late: the surface is at iteration {now}.</source>
        <translation>El veto de la iteración {iteration} llega tarde: la superficie está en la iteración {now}.</translation>
    </message>
    <message>
        <source>The veto of iteration {iteration} has nothing to forbid: no change of topology happens there.</source>
        <translation>El veto de la iteración {iteration} no tiene nada que prohibir: allí no cambia la topología.</translation>
    </message>
    <message>
        <source>The pin {pin} comes too late: the surface is at iteration {now}.</source>
        <translation>La fijación {pin} llega tarde: la superficie está en la iteración {now}.</translation>
    </message>
    <message>
        <source>The pin {pin} holds nothing: no vertex of the surface lies there at iteration {now}.</source>
        <translation>La fijación {pin} no sujeta nada: en la iteración {now} no hay allí ningún vértice de la superficie.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} comes too late: the surface is at iteration {now}.</source>
        <translation>La edición de la iteración {iteration} llega tarde: la superficie está en la iteración {now}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} cannot be made: {cause}.</source>
        <translation>La edición de la iteración {iteration} no es posible: {cause}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} finds no tunnel at {place}.</source>
        <translation>La edición de la iteración {iteration} no encuentra ningún túnel en {place}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} finds no component at {place}.</source>
        <translation>La edición de la iteración {iteration} no encuentra ningún componente en {place}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} finds no cavity at {place}.</source>
        <translation>La edición de la iteración {iteration} no encuentra ninguna cavidad en {place}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} cannot be made: no cap fits into the tunnel at {place}.</source>
        <translation>La edición de la iteración {iteration} no es posible: ninguna tapa encaja en el túnel en {place}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} finds nothing to remove: there is nothing beside that component.</source>
        <translation>La edición de la iteración {iteration} no encuentra nada que quitar: no hay nada más que ese componente.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} would leave nothing of the surface.</source>
        <translation>La edición de la iteración {iteration} no dejaría nada de la superficie.</translation>
    </message>
    <message>
        <source>The surface vanished after {iterations} iterations: the seeds are not in an object of that kind and range.</source>
        <translation>La superficie desapareció tras {iterations} iteraciones: las semillas no están en un objeto de ese tipo e intervalo.</translation>
    </message>
    <message>
        <source>at iteration {iteration} a limit of the topology holds: {cause}; step 4, Grow, asks whether it may happen</source>
        <translation>en la iteración {iteration} retiene un límite de la topología: {cause}; el paso 4, Crecer, pregunta si puede ocurrir</translation>
    </message>
    <message>
        <source>it would enclose a cavity of {ml:3g} ml at {place:1f}</source>
        <translation>encerraría una cavidad de {ml:3g} ml en {place:1f}</translation>
    </message>
    <message>
        <source>a part of {ml:3g} ml would come off at {place:1f}</source>
        <translation>una parte de {ml:3g} ml se separaría en {place:1f}</translation>
    </message>
    <message>
        <source>its fronts would meet at {place:1f}</source>
        <translation>sus frentes se encontrarían en {place:1f}</translation>
    </message>
    <message>
        <source>its fronts would meet at {place:1f} and make a tunnel {around_mm:3g} mm around</source>
        <translation>sus frentes se encontrarían en {place:1f} y formarían un túnel de {around_mm:3g} mm de contorno</translation>
    </message>
    <message>
        <source>a change of its topology ({event}) would happen at {place:1f}</source>
        <translation>un cambio de su topología ({event}) ocurriría en {place:1f}</translation>
    </message>
    <message>
        <source>its voxels cannot be read: {cause}</source>
        <translation>no se pueden leer sus vóxeles: {cause}</translation>
    </message>
    <message>
        <source>no object can be grown here: {cause}</source>
        <translation>aquí no puede crecer ningún objeto: {cause}</translation>
    </message>
    <message>
        <source>the surface was still moving at the iteration limit</source>
        <translation>la superficie aún se movía en el límite de iteraciones</translation>
    </message>
    <message>
        <source>the surface got stuck before it was at rest</source>
        <translation>la superficie se atascó antes de quedar en reposo</translation>
    </message>
    <message>
        <source>the surface rests, but parts that could not be mended would still move</source>
        <translation>la superficie está en reposo, pero partes que no se pudieron arreglar aún se moverían</translation>
    </message>
    <message>
        <source>its voxels cannot be read</source>
        <translation>no se pueden leer sus vóxeles</translation>
    </message>
    <message>
        <source>the surface vanished</source>
        <translation>la superficie desapareció</translation>
    </message>
    <message>
        <source>the surface leaked: {cause}</source>
        <translation>la superficie se fugó: {cause}</translation>
    </message>
    <message>
        <source>the volume jumps from {from_ml:4g} ml in frame {from_frame} to {to_ml:4g} ml</source>
        <translation>el volumen salta de {from_ml:4g} ml en el fotograma {from_frame} a {to_ml:4g} ml</translation>
    </message>
    <message>
        <source>the topology changes from 1 component of genus {genus_before} to 1 component of genus {genus}</source>
        <translation>la topología cambia de 1 componente de género {genus_before} a 1 componente de género {genus}</translation>
    </message>
    <message>
        <source>the topology changes from 1 component of genus {genus_before} to {components} components of genus {genus}</source>
        <translation>la topología cambia de 1 componente de género {genus_before} a {components} componentes de género {genus}</translation>
    </message>
    <message>
        <source>the topology changes from {components_before} components of genus {genus_before} to 1 component of genus {genus}</source>
        <translation>la topología cambia de {components_before} componentes de género {genus_before} a 1 componente de género {genus}</translation>
    </message>
    <message>
        <source>the topology changes from {components_before} components of genus {genus_before} to {components} components of genus {genus}</source>
        <translation>la topología cambia de {components_before} componentes de género {genus_before} a {components} componentes de género {genus}</translation>
    </message>
    <message>
        <source>the topology was held at 1 place, the first at {place} mm</source>
        <translation>la topología se retuvo en 1 lugar, en {place} mm</translation>
    </message>
    <message>
        <source>the topology was held at {places} places, the first at {place} mm</source>
        <translation>la topología se retuvo en {places} lugares, el primero en {place} mm</translation>
    </message>
    <message>
        <source>another object is likelier there, but it fails ({cause}); candidate {candidate} was taken</source>
        <translation>otro objeto es más probable allí, pero falla ({cause}); se tomó el candidato {candidate}</translation>
    </message>
    <message>
        <source>this is a cine (2D images over time: {frames:0f} frames), not a volume; if its frames are slices in space, enter their spacing in step 1, Open</source>
        <translation>es un cine (imágenes 2D en el tiempo: {frames:0f}), no un volumen; si sus fotogramas son cortes en el espacio, introduzca su espaciado en el paso 1, Abrir</translation>
    </message>
    <message>
        <source>{file}: {cause}.</source>
        <translation>{file}: {cause}.</translation>
    </message>
    <message>
        <source>{file}: {cause}</source>
        <translation>{file}: {cause}</translation>
    </message>
    <message>
        <source>{file}: {cause} in line {line:0f}.</source>
        <translation>{file}: {cause}, en la línea {line:0f}.</translation>
    </message>
    <message>
        <source>{file}: cannot be written: {cause}.</source>
        <translation>No se puede escribir {file}: {cause}.</translation>
    </message>
    <message>
        <source>{file}: it holds no series {series}.</source>
        <translation>{file}: no contiene la serie {series}.</translation>
    </message>
    <message>
        <source>{file} cannot be a surface to begin with: it {cause}.</source>
        <translation>{file} no puede ser una superficie inicial: {cause}.</translation>
    </message>
    <message>
        <source>{file} is not the file that the session began with: its SHA-256 differs.</source>
        <translation>{file} no es el archivo con el que empezó la sesión: su SHA-256 es distinto.</translation>
    </message>
    <message>
        <source>{file} is not the volume that the session was made from: its SHA-256 differs.</source>
        <translation>{file} no es el volumen con el que se hizo la sesión: su SHA-256 es distinto.</translation>
    </message>
    <message>
        <source>{file} is not the label map that the walls were made from: its SHA-256 differs.</source>
        <translation>{file} no es el mapa de etiquetas del que se hicieron las barreras: su SHA-256 es distinto.</translation>
    </message>
    <message>
        <source>{file} cannot be used as walls: it has {size} voxels, the volume has {volume}.</source>
        <translation>{file} no puede servir de barreras: tiene {size} vóxeles, el volumen {volume}.</translation>
    </message>
    <message>
        <source>{file} cannot be used as walls: its spacing, origin or direction are not the volume's.</source>
        <translation>{file} no puede servir de barreras: su espaciado, su origen o su dirección no son los del volumen.</translation>
    </message>
    <message>
        <source>{file} cannot be used as walls: all of its voxels are 0.</source>
        <translation>{file} no puede servir de barreras: todos sus vóxeles valen 0.</translation>
    </message>
    <message>
        <source>{file} holds no object: all of its voxels are 0.</source>
        <translation>{file} no contiene ningún objeto: todos sus vóxeles valen 0.</translation>
    </message>
    <message>
        <source>{file} is hardly a label map: it has more than {most:0f} different values.</source>
        <translation>{file} difícilmente es un mapa de etiquetas: tiene más de {most:0f} valores distintos.</translation>
    </message>
    <message>
        <source>{file} does not belong to this volume: a surface in it ({object}) lies outside of it.</source>
        <translation>{file} no pertenece a este volumen: una superficie que contiene ({object}) está fuera de él.</translation>
    </message>
    <message>
        <source>{file} is a folder, not a session.</source>
        <translation>{file} es una carpeta, no una sesión.</translation>
    </message>
    <message>
        <source>{file} cannot be opened: {cause}.</source>
        <translation>No se puede abrir {file}: {cause}.</translation>
    </message>
    <message>
        <source>{file} cannot be read.</source>
        <translation>No se puede leer {file}.</translation>
    </message>
    <message>
        <source>{file} is not a JSON file.</source>
        <translation>{file} no es un archivo JSON.</translation>
    </message>
    <message>
        <source>{file} is neither a session nor a report: {cause}</source>
        <translation>{file} no es ni una sesión ni un informe: {cause}</translation>
    </message>
    <message>
        <source>it holds no objects.</source>
        <translation>no contiene objetos.</translation>
    </message>
    <message>
        <source>it has no seeds.</source>
        <translation>no tiene semillas.</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>no existe tal archivo</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>no existe tal archivo ni carpeta</translation>
    </message>
    <message>
        <source>it is not a file</source>
        <translation>no es un archivo</translation>
    </message>
    <message>
        <source>it is neither a file nor a folder</source>
        <translation>no es ni un archivo ni una carpeta</translation>
    </message>
    <message>
        <source>it cannot be opened (permission?)</source>
        <translation>no se puede abrir (¿falta permiso?)</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>no se puede abrir</translation>
    </message>
    <message>
        <source>it cannot be read</source>
        <translation>no se puede leer</translation>
    </message>
    <message>
        <source>it cannot be read to its end</source>
        <translation>no se puede leer hasta el final</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>el archivo está vacío</translation>
    </message>
    <message>
        <source>the folder cannot be read</source>
        <translation>no se puede leer la carpeta</translation>
    </message>
    <message>
        <source>the folder cannot be read ({reason})</source>
        <translation>no se puede leer la carpeta ({reason})</translation>
    </message>
    <message>
        <source>there is not enough memory to read it</source>
        <translation>no hay memoria suficiente para leerlo</translation>
    </message>
    <message>
        <source>not enough memory to decompress it</source>
        <translation>no hay memoria suficiente para descomprimirlo</translation>
    </message>
    <message>
        <source>it is truncated or damaged</source>
        <translation>está truncado o dañado</translation>
    </message>
    <message>
        <source>it is truncated or damaged ({reason})</source>
        <translation>está truncado o dañado ({reason})</translation>
    </message>
    <message>
        <source>its {format} header cannot be read ({reason})</source>
        <translation>no se puede leer su cabecera {format} ({reason})</translation>
    </message>
    <message>
        <source>it is truncated within its {format} header</source>
        <translation>está truncado dentro de su cabecera {format}</translation>
    </message>
    <message>
        <source>its {format} header is truncated</source>
        <translation>su cabecera {format} está truncada</translation>
    </message>
    <message>
        <source>its {format} header is truncated (no {field})</source>
        <translation>su cabecera {format} está truncada (falta {field})</translation>
    </message>
    <message>
        <source>its {format} header is damaged ({field})</source>
        <translation>su cabecera {format} está dañada ({field})</translation>
    </message>
    <message>
        <source>the {format} file is damaged ({field})</source>
        <translation>el archivo {format} está dañado ({field})</translation>
    </message>
    <message>
        <source>the {format} file is truncated</source>
        <translation>el archivo {format} está truncado</translation>
    </message>
    <message>
        <source>it is not a {format} file</source>
        <translation>no es un archivo {format}</translation>
    </message>
    <message>
        <source>it is not a volume in a known format (NIfTI, NRRD, MetaImage, DICOM, TIFF, GIPL)</source>
        <translation>no es un volumen en un formato conocido (NIfTI, NRRD, MetaImage, DICOM, TIFF, GIPL)</translation>
    </message>
    <message>
        <source>this is a Git LFS pointer, not the file it stands for</source>
        <translation>es un puntero de Git LFS, no el archivo al que representa</translation>
    </message>
    <message>
        <source>this is a compressed DICOM file; unpack it first (gunzip)</source>
        <translation>es un archivo DICOM comprimido; descomprímalo primero (gunzip)</translation>
    </message>
    <message>
        <source>this is a sequence of tracked 2D frames, not a volume; reconstruct a volume from it first</source>
        <translation>es una secuencia de imágenes 2D con seguimiento, no un volumen; reconstruya primero uno a partir de ella</translation>
    </message>
    <message>
        <source>this is a 2D image, a volume is needed</source>
        <translation>es una imagen 2D; se necesita un volumen</translation>
    </message>
    <message>
        <source>this is a 2D image, a volume needs at least two slices along each axis</source>
        <translation>es una imagen 2D; un volumen necesita al menos dos cortes a lo largo de cada eje</translation>
    </message>
    <message>
        <source>this looks like a 2D image in colour (its first axis has {values:0f} values, and the header says nothing of space)</source>
        <translation>parece una imagen 2D en color (su primer eje tiene {values:0f} valores y la cabecera no dice nada del espacio)</translation>
    </message>
    <message>
        <source>the volume has no voxels (a size of 0)</source>
        <translation>el volumen no tiene vóxeles (un tamaño de 0)</translation>
    </message>
    <message>
        <source>the volume has no voxels (a size of 0 in its header)</source>
        <translation>el volumen no tiene vóxeles (un tamaño de 0 en su cabecera)</translation>
    </message>
    <message>
        <source>its voxel spacing is zero, negative or not a number</source>
        <translation>su espaciado de vóxeles es cero, negativo o no es un número</translation>
    </message>
    <message>
        <source>its position or its direction is not a number</source>
        <translation>su posición o su dirección no es un número</translation>
    </message>
    <message>
        <source>its axes are not at right angles (sheared or tilted), which is not supported</source>
        <translation>sus ejes no están en ángulo recto (cizallados o inclinados), lo que no se admite</translation>
    </message>
    <message>
        <source>it has no time points</source>
        <translation>no tiene instantes</translation>
    </message>
    <message>
        <source>the number of its time points is implausible ({frames:0f})</source>
        <translation>el número de sus instantes no es verosímil ({frames:0f})</translation>
    </message>
    <message>
        <source>it declares {declared_gb:1f} GB of voxels, more than the {memory_gb:1f} GB of memory of this computer</source>
        <translation>declara {declared_gb:1f} GB de vóxeles, más que los {memory_gb:1f} GB de memoria de este equipo</translation>
    </message>
    <message>
        <source>a size in its header is implausible ({size})</source>
        <translation>un tamaño de su cabecera no es verosímil ({size})</translation>
    </message>
    <message>
        <source>its data file {data} is missing</source>
        <translation>falta su archivo de datos {data}</translation>
    </message>
    <message>
        <source>it is truncated or damaged: the header declares {declared:0f} bytes of voxels, the file holds {held:0f}</source>
        <translation>está truncado o dañado: la cabecera declara {declared:0f} bytes de vóxeles, el archivo contiene {held:0f}</translation>
    </message>
    <message>
        <source>it is truncated or damaged: the header declares {declared:0f} bytes of voxels, the file holds {held:0f} compressed</source>
        <translation>está truncado o dañado: la cabecera declara {declared:0f} bytes de vóxeles, el archivo contiene {held:0f} comprimidos</translation>
    </message>
    <message>
        <source>its voxel data are truncated or damaged</source>
        <translation>sus datos de vóxeles están truncados o dañados</translation>
    </message>
    <message>
        <source>the voxel data are truncated or damaged</source>
        <translation>los datos de vóxeles están truncados o dañados</translation>
    </message>
    <message>
        <source>the compressed voxel data are truncated or damaged (checksum)</source>
        <translation>los datos de vóxeles comprimidos están truncados o dañados (suma de comprobación)</translation>
    </message>
    <message>
        <source>1 of its voxels is infinite, the first at index ({index: 0f})</source>
        <translation>1 de sus vóxeles es infinito, en el índice ({index: 0f})</translation>
    </message>
    <message>
        <source>{voxels:0f} of its voxels are infinite, the first at index ({index: 0f})</source>
        <translation>{voxels:0f} de sus vóxeles son infinitos, el primero en el índice ({index: 0f})</translation>
    </message>
    <message>
        <source>none of its voxels is a number</source>
        <translation>ninguno de sus vóxeles es un número</translation>
    </message>
    <message>
        <source>its voxels have {components} components (vectors); only scalar and colour volumes are supported</source>
        <translation>sus vóxeles tienen {components} componentes (vectores); solo se admiten volúmenes escalares y en color</translation>
    </message>
    <message>
        <source>it has more than four dimensions</source>
        <translation>tiene más de cuatro dimensiones</translation>
    </message>
    <message>
        <source>it has {dimensions:0f} dimensions; at most four are supported</source>
        <translation>tiene {dimensions:0f} dimensiones; se admiten cuatro como máximo</translation>
    </message>
    <message>
        <source>its voxel type ({type}) is not supported</source>
        <translation>su tipo de vóxel ({type}) no se admite</translation>
    </message>
    <message>
        <source>its voxel type is not supported</source>
        <translation>su tipo de vóxel no se admite</translation>
    </message>
    <message>
        <source>its NIfTI voxel type {type} is not supported</source>
        <translation>su tipo de vóxel NIfTI {type} no se admite</translation>
    </message>
    <message>
        <source>it is not a NIfTI file, whatever its name says</source>
        <translation>no es un archivo NIfTI, diga lo que diga su nombre</translation>
    </message>
    <message>
        <source>this is an Analyze 7.5 file, whose orientation is not reliable; convert it to NIfTI</source>
        <translation>es un archivo Analyze 7.5, cuya orientación no es fiable; conviértalo a NIfTI</translation>
    </message>
    <message>
        <source>the sform in its header has an axis without length</source>
        <translation>la sform de su cabecera tiene un eje sin longitud</translation>
    </message>
    <message>
        <source>the sform in its header is not a number</source>
        <translation>la sform de su cabecera no es un número</translation>
    </message>
    <message>
        <source>its list of data files ({pattern}) is not supported</source>
        <translation>su lista de archivos de datos ({pattern}) no se admite</translation>
    </message>
    <message>
        <source>its encoding ({encoding}) is not supported; raw, gzip and ascii are</source>
        <translation>su codificación ({encoding}) no se admite; raw, gzip y ascii sí</translation>
    </message>
    <message>
        <source>its data files do not divide its voxels evenly</source>
        <translation>sus archivos de datos no dividen sus vóxeles por igual</translation>
    </message>
    <message>
        <source>its byte skip of -1 is not supported here</source>
        <translation>su salto de bytes de -1 no se admite aquí</translation>
    </message>
    <message>
        <source>its voxels are not numbers ({word})</source>
        <translation>sus vóxeles no son números ({word})</translation>
    </message>
    <message>
        <source>its voxels are spread over many data files, which is not supported</source>
        <translation>sus vóxeles están repartidos en muchos archivos de datos, lo que no se admite</translation>
    </message>
    <message>
        <source>its voxels are written as text, which is not supported</source>
        <translation>sus vóxeles están escritos como texto, lo que no se admite</translation>
    </message>
    <message>
        <source>it has {frames:0f} time points; of the volumes of a folder each is one time point</source>
        <translation>tiene {frames:0f} instantes; cada volumen de una carpeta es un solo instante</translation>
    </message>
    <message>
        <source>its size, spacing or place is not the same as in {first}; the volumes of a folder are the time points of one</source>
        <translation>su tamaño, espaciado o posición no es como en {first}; los volúmenes de una carpeta son los instantes de uno solo</translation>
    </message>
    <message>
        <source>its voxels are not of the same type and scale as in {first}; the volumes of a folder are the time points of one</source>
        <translation>sus vóxeles no son del mismo tipo y escala que en {first}; los volúmenes de una carpeta son los instantes de uno solo</translation>
    </message>
    <message>
        <source>it has {pages:0f} pages; of the TIFF files of a folder each is one slice</source>
        <translation>tiene {pages:0f} páginas; de los archivos TIFF de una carpeta cada uno es un corte</translation>
    </message>
    <message>
        <source>its size, resolution or type of voxels is not the same as in {first}; the TIFF files of a folder are the slices of one volume</source>
        <translation>su tamaño, su resolución o el tipo de sus vóxeles no es el mismo que en {first}; los archivos TIFF de una carpeta son los cortes de un volumen</translation>
    </message>
    <message>
        <source>it is no label map: it has voxels whose values are no whole numbers</source>
        <translation>no es un mapa de etiquetas: tiene vóxeles cuyos valores no son números enteros</translation>
    </message>
    <message>
        <source>the DICOM file is truncated or damaged</source>
        <translation>el archivo DICOM está truncado o dañado</translation>
    </message>
    <message>
        <source>the file {part} is truncated or damaged</source>
        <translation>el archivo {part} está truncado o dañado</translation>
    </message>
    <message>
        <source>the file {part} is truncated (cut off within its first 132 bytes)</source>
        <translation>el archivo {part} está truncado (dentro de sus primeros 132 bytes)</translation>
    </message>
    <message>
        <source>the file {part} is truncated (a slice without an image)</source>
        <translation>el archivo {part} está truncado (un corte sin imagen)</translation>
    </message>
    <message>
        <source>the DICOM header of {part} cannot be read ({reason})</source>
        <translation>no se puede leer la cabecera DICOM de {part} ({reason})</translation>
    </message>
    <message>
        <source>it is not a DICOM image (no rows and columns)</source>
        <translation>no es una imagen DICOM (sin filas ni columnas)</translation>
    </message>
    <message>
        <source>the folder holds no DICOM images</source>
        <translation>la carpeta no contiene imágenes DICOM</translation>
    </message>
    <message>
        <source>the folder holds no DICOM images itself; open one of its subfolders</source>
        <translation>la carpeta en sí no contiene imágenes DICOM; abra una de sus subcarpetas</translation>
    </message>
    <message>
        <source>the slice {slice} does not say where it lies (position, orientation or pixel spacing)</source>
        <translation>el corte {slice} no dice dónde está (posición, orientación o espaciado de píxeles)</translation>
    </message>
    <message>
        <source>the slice {slice} has a pixel spacing that is not positive</source>
        <translation>el corte {slice} tiene un espaciado de píxeles que no es positivo</translation>
    </message>
    <message>
        <source>the slice {slice} has directions that span no plane</source>
        <translation>el corte {slice} tiene direcciones que no generan un plano</translation>
    </message>
    <message>
        <source>the slice {slice} has no pixels</source>
        <translation>el corte {slice} no tiene píxeles</translation>
    </message>
    <message>
        <source>the slice {slice} cannot be opened</source>
        <translation>no se puede abrir el corte {slice}</translation>
    </message>
    <message>
        <source>the slice {slice} cannot be read to its end</source>
        <translation>no se puede leer el corte {slice} hasta el final</translation>
    </message>
    <message>
        <source>the slice {slice} has another size than its header says</source>
        <translation>el corte {slice} tiene un tamaño distinto del que dice su cabecera</translation>
    </message>
    <message>
        <source>the slice {slice} is truncated or damaged ({reason})</source>
        <translation>el corte {slice} está truncado o dañado ({reason})</translation>
    </message>
    <message>
        <source>the slice {slice} is truncated or damaged (its pixels cannot be decoded)</source>
        <translation>el corte {slice} está truncado o dañado (no se pueden decodificar sus píxeles)</translation>
    </message>
    <message>
        <source>the slice {slice} is truncated or damaged: it holds less pixels than its header says</source>
        <translation>el corte {slice} está truncado o dañado: contiene menos píxeles de los que dice su cabecera</translation>
    </message>
    <message>
        <source>the slice {slice} is truncated or damaged: its header declares {declared:0f} bytes of pixels, the file holds {held:0f} compressed</source>
        <translation>el corte {slice} está truncado o dañado: su cabecera declara {declared:0f} bytes de píxeles, el archivo contiene {held:0f} comprimidos</translation>
    </message>
    <message>
        <source>the slice {slice} is damaged: a value is larger than its header allows</source>
        <translation>el corte {slice} está dañado: un valor es mayor de lo que permite su cabecera</translation>
    </message>
    <message>
        <source>its slices have different sizes</source>
        <translation>sus cortes tienen tamaños distintos</translation>
    </message>
    <message>
        <source>its slices have different orientations</source>
        <translation>sus cortes tienen orientaciones distintas</translation>
    </message>
    <message>
        <source>its slices have different pixel spacings</source>
        <translation>sus cortes tienen espaciados de píxeles distintos</translation>
    </message>
    <message>
        <source>its slices are partly in colour</source>
        <translation>parte de sus cortes está en color</translation>
    </message>
    <message>
        <source>its slices are less than two pixels wide</source>
        <translation>sus cortes tienen menos de dos píxeles de ancho</translation>
    </message>
    <message>
        <source>several of its slices lie in the same place with different content, and not equally many in every place (time points or echoes that are not complete)</source>
        <translation>varios de sus cortes están en el mismo lugar con contenido distinto, y no el mismo número en todos los lugares (instantes o ecos incompletos)</translation>
    </message>
    <message>
        <source>all its slices lie in the same place: 2D images over time, not a volume</source>
        <translation>todos sus cortes están en el mismo lugar: imágenes 2D en el tiempo, no un volumen</translation>
    </message>
    <message>
        <source>this is a single slice, a 2D image; give the folder with the whole series</source>
        <translation>es un solo corte, una imagen 2D; indique la carpeta con la serie completa</translation>
    </message>
    <message>
        <source>its slices are shifted against each other by {shift_mm:4g} mm, more than they are apart; this is no gantry tilt</source>
        <translation>sus cortes están desplazados entre sí {shift_mm:4g} mm, más que su separación; no es una inclinación del gantry</translation>
    </message>
    <message>
        <source>{cause}, too unevenly to resample</source>
        <translation>{cause}, demasiado desigual para remuestrear</translation>
    </message>
    <message>
        <source>the number of frames in {slice} is implausible</source>
        <translation>el número de fotogramas en {slice} no es verosímil</translation>
    </message>
    <message>
        <source>pixels of {stored:0f} bits in {allocated:0f} are not supported ({slice})</source>
        <translation>no se admiten píxeles de {stored:0f} bits en {allocated:0f} ({slice})</translation>
    </message>
    <message>
        <source>pixels with {samples:0f} samples are not supported ({slice})</source>
        <translation>no se admiten píxeles con {samples:0f} muestras ({slice})</translation>
    </message>
    <message>
        <source>colour of {bits:0f} bits is not supported ({slice})</source>
        <translation>no se admite color de {bits:0f} bits ({slice})</translation>
    </message>
    <message>
        <source>compressed pixels of one bit are not supported ({slice})</source>
        <translation>no se admiten píxeles comprimidos de un bit ({slice})</translation>
    </message>
    <message>
        <source>the colour space {space} is not supported ({slice})</source>
        <translation>no se admite el espacio de color {space} ({slice})</translation>
    </message>
    <message>
        <source>it does not say which segment each frame is of</source>
        <translation>no dice de qué segmento es cada fotograma</translation>
    </message>
    <message>
        <source>it is a segmentation that is not binary ({bits:0f} bits per voxel), which is not supported</source>
        <translation>es una segmentación que no es binaria ({bits:0f} bits por vóxel), lo que no se admite</translation>
    </message>
    <message>
        <source>its pixels are compressed, which is not supported for a segmentation</source>
        <translation>sus píxeles están comprimidos, lo que no se admite en una segmentación</translation>
    </message>
    <message>
        <source>it is truncated or damaged: it holds less pixels than its header says</source>
        <translation>está truncado o dañado: contiene menos píxeles de los que dice su cabecera</translation>
    </message>
    <message>
        <source>it does not say where every frame lies</source>
        <translation>no dice dónde está cada fotograma</translation>
    </message>
    <message>
        <source>its frames do not lie one behind the other, which is not supported</source>
        <translation>sus fotogramas no están uno detrás de otro, lo que no se admite</translation>
    </message>
    <message>
        <source>it does not give the distance between its slices</source>
        <translation>no indica la distancia entre sus cortes</translation>
    </message>
    <message>
        <source>the distance of its frames is implausible</source>
        <translation>la distancia entre sus fotogramas no es verosímil</translation>
    </message>
    <message>
        <source>its frames are not evenly spaced</source>
        <translation>sus fotogramas no están espaciados de manera uniforme</translation>
    </message>
    <message>
        <source>it cannot be read because the decoder {program} is not there</source>
        <translation>no se puede leer porque falta el decodificador {program}</translation>
    </message>
    <message>
        <source>the decoder cannot be started ({reason})</source>
        <translation>no se puede iniciar el decodificador ({reason})</translation>
    </message>
    <message>
        <source>the decoder {program} cannot be started ({reason})</source>
        <translation>no se puede iniciar el decodificador {program} ({reason})</translation>
    </message>
    <message>
        <source>the decoder broke down on it ({how}); the file is damaged or too large for it</source>
        <translation>el decodificador falló con él ({how}); el archivo está dañado o es demasiado grande para él</translation>
    </message>
    <message>
        <source>the decoder broke down on {part} ({how}); the file is damaged or too large for it</source>
        <translation>el decodificador falló con {part} ({how}); el archivo está dañado o es demasiado grande para él</translation>
    </message>
    <message>
        <source>the decoder got stuck on it and was stopped; the file is damaged</source>
        <translation>el decodificador se atascó con él y se detuvo; el archivo está dañado</translation>
    </message>
    <message>
        <source>the decoder got stuck on {part} and was stopped; the file is damaged</source>
        <translation>el decodificador se atascó con {part} y se detuvo; el archivo está dañado</translation>
    </message>
    <message>
        <source>the decoder gave an answer without meaning</source>
        <translation>el decodificador dio una respuesta sin sentido</translation>
    </message>
    <message>
        <source>the decoder gave an answer without meaning on it</source>
        <translation>el decodificador dio una respuesta sin sentido sobre él</translation>
    </message>
    <message>
        <source>the decoder gave an answer without meaning on {part}</source>
        <translation>el decodificador dio una respuesta sin sentido sobre {part}</translation>
    </message>
    <message>
        <source>the decoder gave less than it announced</source>
        <translation>el decodificador dio menos de lo que anunció</translation>
    </message>
    <message>
        <source>decoding it takes more memory than its size allows</source>
        <translation>decodificarlo necesita más memoria de la que permite su tamaño</translation>
    </message>
    <message>
        <source>its data cannot be decoded ({reason})</source>
        <translation>no se pueden decodificar sus datos ({reason})</translation>
    </message>
    <message>
        <source>the mesh file is truncated or damaged</source>
        <translation>el archivo de malla está truncado o dañado</translation>
    </message>
    <message>
        <source>it is not an STL file, or it is truncated</source>
        <translation>no es un archivo STL, o está truncado</translation>
    </message>
    <message>
        <source>triangle strips are not supported</source>
        <translation>no se admiten tiras de triángulos</translation>
    </message>
    <message>
        <source>it holds no triangles</source>
        <translation>no contiene triángulos</translation>
    </message>
    <message>
        <source>a coordinate is not a number or infinite</source>
        <translation>una coordenada no es un número o es infinita</translation>
    </message>
    <message>
        <source>a face names a vertex that is not there</source>
        <translation>una cara nombra un vértice que no existe</translation>
    </message>
    <message>
        <source>a face has less than three corners</source>
        <translation>una cara tiene menos de tres vértices</translation>
    </message>
    <message>
        <source>a face is damaged</source>
        <translation>una cara está dañada</translation>
    </message>
    <message>
        <source>a vertex is not three numbers</source>
        <translation>un vértice no son tres números</translation>
    </message>
    <message>
        <source>its triangles have no area</source>
        <translation>sus triángulos no tienen área</translation>
    </message>
    <message>
        <source>has no triangles</source>
        <translation>no tiene triángulos</translation>
    </message>
    <message>
        <source>is not closed</source>
        <translation>no está cerrada</translation>
    </message>
    <message>
        <source>is not manifold</source>
        <translation>no es una variedad</translation>
    </message>
    <message>
        <source>has faces that are not oriented alike</source>
        <translation>tiene caras que no están orientadas por igual</translation>
    </message>
    <message>
        <source>intersects itself ({pairs:0f} pairs of faces)</source>
        <translation>se interseca a sí misma ({pairs:0f} pares de caras)</translation>
    </message>
    <message>
        <source>intersects itself in single precision</source>
        <translation>se interseca a sí misma en precisión simple</translation>
    </message>
    <message>
        <source>has components that lie where they bound nothing</source>
        <translation>tiene componentes situados donde no delimitan nada</translation>
    </message>
    <message>
        <source>encloses no volume</source>
        <translation>no encierra ningún volumen</translation>
    </message>
    <message>
        <source>has no voxel of the value {label:0f}</source>
        <translation>no hay ningún vóxel con el valor {label:0f}</translation>
    </message>
    <message>
        <source>has no voxel that is not 0</source>
        <translation>no hay ningún vóxel distinto de 0</translation>
    </message>
    <message>
        <source>is a mesh, which has no labels</source>
        <translation>es una malla, que no tiene etiquetas</translation>
    </message>
    <message>
        <source>became surfaces without the label {label:0f}</source>
        <translation>al convertirse en superficies se perdió la etiqueta {label:0f}</translation>
    </message>
    <message>
        <source>has labels that lie in each other so finely that their surfaces cannot be kept apart</source>
        <translation>sus etiquetas están tan finamente entrelazadas que no se pueden mantener separadas sus superficies</translation>
    </message>
    <message>
        <source>has a surface of more than {most:0f} triangles</source>
        <translation>su superficie tendría más de {most:0f} triángulos</translation>
    </message>
    <message>
        <source>it is a folder, not a file name</source>
        <translation>es una carpeta, no un nombre de archivo</translation>
    </message>
    <message>
        <source>a folder has this name</source>
        <translation>una carpeta tiene este nombre</translation>
    </message>
    <message>
        <source>the data did not reach the disk (is it full?)</source>
        <translation>los datos no llegaron al disco (¿está lleno?)</translation>
    </message>
    <message>
        <source>the disk may be full</source>
        <translation>puede que el disco esté lleno</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>no se puede abrir el archivo</translation>
    </message>
    <message>
        <source>NIfTI cannot hold more than 32767 voxels or frames along an axis</source>
        <translation>NIfTI no puede contener más de 32767 vóxeles o fotogramas a lo largo de un eje</translation>
    </message>
    <message>
        <source>the mesh is too large for DICOM</source>
        <translation>la malla es demasiado grande para DICOM</translation>
    </message>
    <message>
        <source>it is too large for DICOM</source>
        <translation>es demasiado grande para DICOM</translation>
    </message>
    <message>
        <source>the mesh is too large for 3MF</source>
        <translation>la malla es demasiado grande para 3MF</translation>
    </message>
    <message>
        <source>the object {object} holds the centre of no voxel</source>
        <translation>el objeto {object} no contiene el centro de ningún vóxel</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>permiso denegado</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>no queda espacio en el disco</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>el sistema de archivos es de solo lectura</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>no existe el archivo o la carpeta</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>el nombre del archivo es demasiado largo</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>una parte de la ruta no es una carpeta</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>se superó la cuota de disco</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>error de entrada/salida</translation>
    </message>
    <message>
        <source>The pin at {place} mm lies outside of the volume.</source>
        <translation>La fijación en {place} mm está fuera del volumen.</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies outside of the volume.</source>
        <translation>La barrera en {place} mm está fuera del volumen.</translation>
    </message>
    <message>
        <source>The wall disc at {place} mm lies outside of the volume.</source>
        <translation>El disco de barrera en {place} mm está fuera del volumen.</translation>
    </message>
    <message>
        <source>The allowed place {place} lies outside of the volume.</source>
        <translation>El lugar permitido {place} está fuera del volumen.</translation>
    </message>
    <message>
        <source>The place to hold {place} lies outside of the volume.</source>
        <translation>El lugar que se ha de retener {place} está fuera del volumen.</translation>
    </message>
    <message>
        <source>The surface to begin with, {file}, lies outside of the volume.</source>
        <translation>La superficie inicial, {file}, está fuera del volumen.</translation>
    </message>
    <message>
        <source>The surface to begin with cannot become another one on the way: begin again.</source>
        <translation>La superficie inicial no puede convertirse en otra sobre la marcha: empiece de nuevo.</translation>
    </message>
    <message>
        <source>The object '{object}' has no mesh that could be a wall.</source>
        <translation>El objeto «{object}» no tiene malla que pueda ser una barrera.</translation>
    </message>
    <message>
        <source>The label map of the walls has not the volume's size.</source>
        <translation>El mapa de etiquetas de las barreras no tiene el tamaño del volumen.</translation>
    </message>
    <message>
        <source>An allowed place has nothing to allow: the components and the genus have no limit.</source>
        <translation>Un lugar permitido no tiene nada que permitir: los componentes y el género no tienen límite.</translation>
    </message>
    <message>
        <source>A place to hold has nothing to hold: the components and the genus have no limit.</source>
        <translation>Un lugar que se ha de retener no tiene nada que retener: los componentes y el género no tienen límite.</translation>
    </message>
    <message>
        <source>There is nothing to ask about: the components and the genus have no limit.</source>
        <translation>No hay nada que preguntar: los componentes y el género no tienen límite.</translation>
    </message>
    <message>
        <source>A pin cannot be set before the first step of a correction: make a step first.</source>
        <translation>No se puede fijar antes del primer paso de una corrección: dé primero un paso.</translation>
    </message>
    <message>
        <source>The sensitivity cannot be told of a growth with vetoes, pins or edits: they name an iteration, and a perturbed run has others.</source>
        <translation>No se puede indicar la sensibilidad de un crecimiento con vetos, fijaciones o ediciones: nombran una iteración, y una ejecución perturbada tiene otras.</translation>
    </message>
    <message>
        <source>The surface vanished.</source>
        <translation>La superficie desapareció.</translation>
    </message>
    <message>
        <source>no DICOM file can be made: {cause}</source>
        <translation>no se puede hacer ningún archivo DICOM: {cause}</translation>
    </message>
    <message>
        <source>the volume was not read from DICOM, and a DICOM file belongs to a patient and a study</source>
        <translation>el volumen no se leyó de DICOM, y un archivo DICOM pertenece a un paciente y a un estudio</translation>
    </message>
    <message>
        <source>the series does not say where its slices lie</source>
        <translation>la serie no dice dónde están sus cortes</translation>
    </message>
    <message>
        <source>its positions are in the frame of the ultrasound volume, not of the patient</source>
        <translation>sus posiciones se refieren al volumen de ecografía, no al paciente</translation>
    </message>
    <message>
        <source>its spacing was given by the user, not by the series</source>
        <translation>su espaciado lo dio el usuario, no la serie</translation>
    </message>
    <message>
        <source>'{text}' is longer than 64 bytes</source>
        <translation>«{text}» supera los 64 bytes</translation>
    </message>
    <message>
        <source>'{text}' holds a control character or a backslash</source>
        <translation>«{text}» contiene un carácter de control o una barra invertida</translation>
    </message>
    <message>
        <source>the label map is not on the grid of the series</source>
        <translation>el mapa de etiquetas no está en la cuadrícula de la serie</translation>
    </message>
    <message>
        <source>tetrahedra are made by gmsh or TetGen, and neither program is installed (Debian's packages are gmsh and tetgen)</source>
        <translation>los tetraedros los hacen gmsh o TetGen, y ninguno de los dos programas está instalado (los paquetes de Debian son gmsh y tetgen)</translation>
    </message>
    <message>
        <source>there are no tetrahedra of the object '{object}': {cause}.</source>
        <translation>no hay tetraedros del objeto «{object}»: {cause}.</translation>
    </message>
    <message>
        <source>{file}: there is no frame {frame:0f}; it has the frames 0 to {last:0f}.</source>
        <translation>{file}: no existe el fotograma {frame:0f}; tiene los fotogramas 0 a {last:0f}.</translation>
    </message>
    <message>
        <source>{file}: there is no frame {frame:0f}; it has one frame, 0.</source>
        <translation>{file}: no existe el fotograma {frame:0f}; solo tiene uno, el 0.</translation>
    </message>
    <message>
        <source>the slice {slice} holds less frames than its header says</source>
        <translation>el corte {slice} contiene menos fotogramas de los que indica su cabecera</translation>
    </message>
    <message>
        <source>the palette of {slice} is missing or damaged</source>
        <translation>la paleta de {slice} falta o está dañada</translation>
    </message>
    <message>
        <source>There are {frames:0f} time points; frame 0 is used (step 1, Open, chooses another).</source>
        <translation>Hay {frames:0f} instantes; se usa el fotograma 0 (el paso 1, Abrir, elige otro).</translation>
    </message>
    <message>
        <source>The volume is uncalibrated: its file does not give the spacing, 1 mm is assumed where it is missing, and lengths and volumes mean nothing until it is entered in step 1, Open.</source>
        <translation>El volumen está sin calibrar: su archivo no da el espaciado, se supone 1 mm donde falta, y longitudes y volúmenes no significan nada hasta que se introduzca en el paso 1, Abrir.</translation>
    </message>
    <message>
        <source>stack {stack:0f} ({slices:0f} slices)</source>
        <translation>pila {stack:0f} ({slices:0f} cortes)</translation>
    </message>
    <message>
        <source>it holds {series:0f} series or stacks, choose one in step 1, Open: {choices}</source>
        <translation>contiene {series:0f} series o pilas, elija una en el paso 1, Abrir: {choices}</translation>
    </message>
    <message>
        <source>No point of the lattice lies in A or B: there is no Dice coefficient.</source>
        <translation>Ningún punto de la cuadrícula está en A o B: no hay coeficiente de Dice.</translation>
    </message>
    <message>
        <source>its slices are unevenly spaced ({list})</source>
        <translation>sus cortes están espaciados de forma desigual ({list})</translation>
    </message>
    <message>
        <source>its slices are unevenly spaced ({list}), 1 seems to be missing</source>
        <translation>sus cortes están espaciados de forma desigual ({list}); parece faltar 1</translation>
    </message>
    <message>
        <source>its slices are unevenly spaced ({list}), {missing:0f} seem to be missing</source>
        <translation>sus cortes están espaciados de forma desigual ({list}); parecen faltar {missing:0f}</translation>
    </message>
    <message>
        <source>1 gap of {gap_mm:4g} mm</source>
        <translation>1 hueco de {gap_mm:4g} mm</translation>
    </message>
    <message>
        <source>{gaps:0f} gaps of {gap_mm:4g} mm</source>
        <translation>{gaps:0f} huecos de {gap_mm:4g} mm</translation>
    </message>
    <message>
        <source>{gaps:0f} of {gap_mm:4g} mm</source>
        <translation>{gaps:0f} de {gap_mm:4g} mm</translation>
    </message>
    <message>
        <source>{gaps:0f} of {gap_mm:4g} mm …</source>
        <translation>{gaps:0f} de {gap_mm:4g} mm…</translation>
    </message>
    <message>
        <source>Colour was turned into luminance (0.2125 R + 0.7154 G + 0.0721 B).</source>
        <translation>El color se convirtió en luminancia (0.2125 R + 0.7154 G + 0.0721 B).</translation>
    </message>
    <message>
        <source>The distance unit {unit} is taken as millimetres.</source>
        <translation>La unidad de distancia {unit} se toma como milímetros.</translation>
    </message>
    <message>
        <source>The space units {units} are taken as millimetres.</source>
        <translation>Las unidades de espacio {units} se toman como milímetros.</translation>
    </message>
    <message>
        <source>The lengths in the header are in metres and were turned into millimetres.</source>
        <translation>Las longitudes de la cabecera están en metros y se convirtieron a milímetros.</translation>
    </message>
    <message>
        <source>The lengths in the header are in micrometres and were turned into millimetres.</source>
        <translation>Las longitudes de la cabecera están en micrómetros y se convirtieron a milímetros.</translation>
    </message>
    <message>
        <source>The header does not say how the volume lies in space (qform and sform codes are 0).</source>
        <translation>La cabecera no dice cómo está el volumen en el espacio (los códigos de qform y sform son 0).</translation>
    </message>
    <message>
        <source>The header does not say how the volume lies in space; its axes are taken as LPS.</source>
        <translation>La cabecera no dice cómo está el volumen en el espacio; sus ejes se toman como LPS.</translation>
    </message>
    <message>
        <source>The sform and the qform of the header disagree (by up to {apart_mm:0f} mm); the qform is used.</source>
        <translation>La sform y la qform de la cabecera no coinciden (hasta {apart_mm:0f} mm); se usa la qform.</translation>
    </message>
    <message>
        <source>TIFF does not say how far apart the slices are nor how they lie; 1 mm and LPS axes are assumed.</source>
        <translation>TIFF no dice ni la distancia entre los cortes ni cómo están colocados; se suponen 1 mm y ejes LPS.</translation>
    </message>
    <message>
        <source>This is a segmentation: its voxels hold the numbers of the segments.</source>
        <translation>Es una segmentación: sus vóxeles contienen los números de los segmentos.</translation>
    </message>
    <message>
        <source>The spacing was given by the user; the file says {x_mm:4g} mm, {y_mm:4g} mm, {z_mm:4g} mm.</source>
        <translation>El espaciado lo dio el usuario; el archivo dice {x_mm:4g} mm, {y_mm:4g} mm, {z_mm:4g} mm.</translation>
    </message>
    <message>
        <source>{none:0f} of {voxels:0f} voxels are not a number: they count as outside of the field of view.</source>
        <translation>{none:0f} de {voxels:0f} vóxeles no son un número: cuentan como fuera del campo de visión.</translation>
    </message>
    <message>
        <source>1 slice is a copy of another and was left out.</source>
        <translation>1 corte es copia de otro y se omitió.</translation>
    </message>
    <message>
        <source>{copies:0f} slices are copies of others and were left out.</source>
        <translation>{copies:0f} cortes son copias de otros y se omitieron.</translation>
    </message>
    <message>
        <source>The slices are tilted by {degrees:1f} degrees (gantry tilt) and were resampled to a straight grid.</source>
        <translation>Los cortes están inclinados {degrees:1f} grados (inclinación del gantry) y se remuestrearon en una cuadrícula recta.</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced ({list}); they were resampled to a distance of {spacing_mm:4g} mm. What lies in the gaps is interpolated.</source>
        <translation>Los cortes están espaciados de forma desigual ({list}); se remuestrearon a una distancia de {spacing_mm:4g} mm. Lo que hay en los huecos está interpolado.</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced ({list}), 1 seems to be missing; they were resampled to a distance of {spacing_mm:4g} mm. What lies in the gaps is interpolated.</source>
        <translation>Los cortes están espaciados de forma desigual ({list}), parece faltar 1; se remuestrearon a una distancia de {spacing_mm:4g} mm. Lo que hay en los huecos está interpolado.</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced ({list}), {missing:0f} seem to be missing; they were resampled to a distance of {spacing_mm:4g} mm. What lies in the gaps is interpolated.</source>
        <translation>Los cortes están espaciados de forma desigual ({list}), parecen faltar {missing:0f}; se remuestrearon a una distancia de {spacing_mm:4g} mm. Lo que hay en los huecos está interpolado.</translation>
    </message>
    <message>
        <source>The header does not say where the slices lie; they are taken one behind the other, with LPS axes.</source>
        <translation>La cabecera no dice dónde están los cortes; se toman uno detrás de otro, con ejes LPS.</translation>
    </message>
    <message>
        <source>The file does not say how the volume lies in the patient: columns are taken to run to the right, rows to the back and slices downwards.</source>
        <translation>El archivo no dice cómo está el volumen en el paciente: se supone que las columnas van hacia la derecha, las filas hacia atrás y los cortes hacia abajo.</translation>
    </message>
    <message>
        <source>The file breaks off: its header declares {frames:0f} time points, and only the first one is there in full.</source>
        <translation>El archivo se interrumpe: su cabecera declara {frames:0f} instantes y solo el primero está completo.</translation>
    </message>
    <message>
        <source>The file breaks off: its header declares {frames:0f} time points, and only the first {whole:0f} are there in full.</source>
        <translation>El archivo se interrumpe: su cabecera declara {frames:0f} instantes y solo los primeros {whole:0f} están completos.</translation>
    </message>
    <message>
        <source>1 file of DICOM in the folder is without an image and left out.</source>
        <translation>1 archivo DICOM de la carpeta no tiene imagen y se omite.</translation>
    </message>
    <message>
        <source>{files:0f} files of DICOM in the folder are without an image and left out.</source>
        <translation>{files:0f} archivos DICOM de la carpeta no tienen imagen y se omiten.</translation>
    </message>
    <message>
        <source>1 file of other series is truncated or damaged.</source>
        <translation>1 archivo de otras series está truncado o dañado.</translation>
    </message>
    <message>
        <source>{files:0f} files of other series are truncated or damaged.</source>
        <translation>{files:0f} archivos de otras series están truncados o dañados.</translation>
    </message>
    <message>
        <source>1 file in the folder is not DICOM and left out: {names}.</source>
        <translation>1 archivo de la carpeta no es DICOM y se omite: {names}.</translation>
    </message>
    <message>
        <source>{files:0f} files in the folder are not DICOM and left out: {names}.</source>
        <translation>{files:0f} archivos de la carpeta no son DICOM y se omiten: {names}.</translation>
    </message>
    <message>
        <source>{files:0f} files in the folder are not DICOM and left out: {names} and {more:0f} more.</source>
        <translation>{files:0f} archivos de la carpeta no son DICOM y se omiten: {names} y {more:0f} más.</translation>
    </message>
    <message>
        <source>1 file in the folder is not DICOM and left out.</source>
        <translation>1 archivo de la carpeta no es DICOM y se omite.</translation>
    </message>
    <message>
        <source>{files:0f} files in the folder are not DICOM and left out.</source>
        <translation>{files:0f} archivos de la carpeta no son DICOM y se omiten.</translation>
    </message>
    <message>
        <source>Its stacks of one pitch each are to be had alone: {list}.</source>
        <translation>Sus pilas de un único espaciado entre cortes se pueden abrir por separado: {list}.</translation>
    </message>
    <message>
        <source>Its stacks of one pitch each are to be had alone.</source>
        <translation>Sus pilas de un único espaciado entre cortes se pueden abrir por separado.</translation>
    </message>
    <message>
        <source>Nothing is chosen: {cause}.</source>
        <translation>No hay nada elegido: {cause}.</translation>
    </message>
    <message>
        <source>{series} ({what}1 file, {size} voxels of {spacing_mm: 4g} mm)</source>
        <translation>{series} ({what}1 archivo, {size} vóxeles de {spacing_mm: 4g} mm)</translation>
    </message>
    <message>
        <source>{series} ({what}{files:0f} files, {size} voxels of {spacing_mm: 4g} mm)</source>
        <translation>{series} ({what}{files:0f} archivos, {size} vóxeles de {spacing_mm: 4g} mm)</translation>
    </message>
    <message>
        <source>{series} ({what}1 file, no volume)</source>
        <translation>{series} ({what}1 archivo, sin volumen)</translation>
    </message>
    <message>
        <source>{series} ({what}{files:0f} files, no volume)</source>
        <translation>{series} ({what}{files:0f} archivos, sin volumen)</translation>
    </message>
    <message>
        <source>{cause}.</source>
        <translation>{cause}.</translation>
    </message>
    <message>
        <source>{object}: {cause}</source>
        <translation>{object}: {cause}</translation>
    </message>
    <message>
        <source>{object} is empty: there are no distances.</source>
        <translation>{object} está vacío: no hay distancias.</translation>
    </message>
    <message>
        <source>{object} is not closed: it has no volume, and there is no Dice coefficient. Distances are measured from and to what there is of its surface.</source>
        <translation>{object} no está cerrado: no tiene volumen y no hay coeficiente de Dice. Las distancias se miden desde y hasta lo que hay de su superficie.</translation>
    </message>
    <message>
        <source>{object} is closed, but not all of its faces are oriented alike: it has no volume, and there is no Dice coefficient.</source>
        <translation>{object} está cerrado, pero no todas sus caras están orientadas por igual: no tiene volumen y no hay coeficiente de Dice.</translation>
    </message>
    <message>
        <source>{object} is not a manifold: its genus and cavities cannot be counted.</source>
        <translation>{object} no es una variedad: su género y sus cavidades no se pueden contar.</translation>
    </message>
    <message>
        <source>{object} is inside out; it was turned.</source>
        <translation>{object} está del revés; se le dio la vuelta.</translation>
    </message>
    <message>
        <source>A and B do not overlap: their surfaces are {apart_mm:4g} mm apart, the centres of their boxes {centres_mm:4g} mm.</source>
        <translation>A y B no se solapan: sus superficies están a {apart_mm:4g} mm, los centros de sus cajas a {centres_mm:4g} mm.</translation>
    </message>
    <message>
        <source>A and B do not overlap: their surfaces are {apart_mm:4g} mm apart, the centres of their boxes {centres_mm:4g} mm. With the signs of x and y turned in one of them they would meet: is one in RAS and does not say so?</source>
        <translation>A y B no se solapan: sus superficies están a {apart_mm:4g} mm, los centros de sus cajas a {centres_mm:4g} mm. Con los signos de x e y cambiados en uno de ellos se encontrarían: ¿está uno en RAS sin decirlo?</translation>
    </message>
    <message>
        <source>A part of the surface lies outside of the volume: intensities and label maps are of the rest.</source>
        <translation>Una parte de la superficie está fuera del volumen: las intensidades y los mapas de etiquetas son los del resto.</translation>
    </message>
    <message>
        <source>{voxels:0f} voxels inside have no finite value and do not count.</source>
        <translation>{voxels:0f} vóxeles del interior no tienen valor finito y no cuentan.</translation>
    </message>
    <message>
        <source>No voxel with a value has its centre inside.</source>
        <translation>Ningún vóxel con valor tiene su centro en el interior.</translation>
    </message>
    <message>
        <source>“{object}” has no cavity, and so no wall around one.</source>
        <translation>«{object}» no tiene cavidad y, por tanto, ninguna pared a su alrededor.</translation>
    </message>
    <message>
        <source>Positions are in the frame of the ultrasound volume, not of the patient: its axes are taken as LPS.</source>
        <translation>Las posiciones se refieren al volumen de ecografía, no al paciente: sus ejes se toman como LPS.</translation>
    </message>
    <message>
        <source>MONOCHROME1: low values are bright on a display.</source>
        <translation>MONOCHROME1: los valores bajos se ven claros en pantalla.</translation>
    </message>
    <message>
        <source>The header scales voxels by 0, which would make them all alike; 1 is taken instead.</source>
        <translation>La cabecera escala los vóxeles por 0, lo que los haría todos iguales; se toma 1 en su lugar.</translation>
    </message>
    <message>
        <source>it holds several series or stacks, choose one in step 1, Open</source>
        <translation>contiene varias series o pilas, elija una en el paso 1, Abrir</translation>
    </message>
    <message>
        <source>This session does not say where its volume is. Choose it.</source>
        <translation>Esta sesión no dice dónde está su volumen. Elíjalo.</translation>
    </message>
    <message>
        <source>This session does not say where the label map of its walls is. Choose it.</source>
        <translation>Esta sesión no dice dónde está el mapa de etiquetas de sus paredes. Elíjalo.</translation>
    </message>
    <message>
        <source>This session does not say where the file of a surface is that an object begins with. Choose it.</source>
        <translation>Esta sesión no dice dónde está el archivo de una superficie con la que empieza un objeto. Elíjalo.</translation>
    </message>
    <message>
        <source>{file}: series {series} is not the one that the session was made from: its voxels differ.</source>
        <translation>{file}: la serie {series} no es la serie con la que se hizo la sesión: sus vóxeles son distintos.</translation>
    </message>
    <message>
        <source>{file}: none of its series has the voxels that the session was made from.</source>
        <translation>{file}: ninguna de sus series tiene los vóxeles con los que se hizo la sesión.</translation>
    </message>
    <message>
        <source>the surface does not enclose the seed at {place:1f} mm, which lies {distance_mm:1f} mm outside of it: the image or other clicks speak against it</source>
        <translation>la superficie no encierra la semilla en {place:1f} mm, que queda {distance_mm:1f} mm fuera: la imagen u otros puntos lo contradicen</translation>
    </message>
    <message>
        <source>the surface encloses the click outside of the object at {place:1f} mm, which lies {distance_mm:1f} mm within it: the image or other clicks speak against it</source>
        <translation>la superficie encierra el punto exterior en {place:1f} mm, que queda {distance_mm:1f} mm dentro: la imagen u otros puntos lo contradicen</translation>
    </message>
    <message>
        <source>The seed at {place:1f} mm and the click outside of the object at {outside:1f} mm contradict each other: both lie in one voxel.</source>
        <translation>La semilla en {place:1f} mm y el punto exterior en {outside:1f} mm se contradicen: ambos están en el mismo vóxel.</translation>
    </message>
    <message>
        <source>the mesh is written as it was given: triangles with an angle under 15 degrees: {thin_faces:0f}, edges whose faces meet at less than 20 degrees: {sharp_edges:0f} (handlebody-cli edit --polish all betters them)</source>
        <translation>La malla se escribe tal como se dio: triángulos con un ángulo de menos de 15 grados: {thin_faces:0f}, aristas cuyas caras se encuentran a menos de 20 grados: {sharp_edges:0f} (handlebody-cli edit --polish all los mejora)</translation>
    </message>
    <message>
        <source>The segmentation has {layers:0f} layers, since segments overlap: only the segments of the first layer are read.</source>
        <translation>La segmentación tiene {layers:0f} capas, porque hay segmentos que se solapan: solo se leen los segmentos de la primera capa.</translation>
    </message>
    <message>
        <source>labels of the map that was given overlap: {voxels:0f} voxels of this one are left to smaller ones that hold them, too</source>
        <translation>las etiquetas del mapa dado se solapan: {voxels:0f} vóxeles de esta quedan para otras más pequeñas que también los contienen</translation>
    </message>
    <message>
        <source>it has no label called '{name}'; it has: {names}</source>
        <translation>no tiene ninguna etiqueta llamada «{name}»; tiene: {names}</translation>
    </message>
    <message>
        <source>it has no label called '{name}': it names none</source>
        <translation>no tiene ninguna etiqueta llamada «{name}»: no nombra ninguna</translation>
    </message>
    <message>
        <source>it has several labels called '{name}': their number tells them apart</source>
        <translation>tiene varias etiquetas llamadas «{name}»: su número las distingue</translation>
    </message>
    <message>
        <source>has no voxel of the label {label:0f} that no smaller label holds, too</source>
        <translation>no tiene ningún vóxel de la etiqueta {label:0f} que no contenga también otra más pequeña</translation>
    </message>
    <message>
        <source>has {tunnels:0f} tunnels, and no closing or opening leaves {most:0f} or fewer</source>
        <translation>tiene {tunnels:0f} túneles, y ningún cierre ni apertura deja {most:0f} o menos</translation>
    </message>
    <message>
        <source>The surface to begin with, {file}, meets the object '{object}', which comes before it. Labels of one map that touch are kept apart where they are opened together, with the same smoothing, largest part and tunnels.</source>
        <translation>La superficie inicial, {file}, toca el objeto «{object}», que va antes que ella. Las etiquetas de un mismo mapa que se tocan se mantienen separadas si se abren juntas, con los mismos ajustes de suavizado, parte mayor y túneles.</translation>
    </message>
    <message>
        <source>it is not a mesh file (.stl, .vtp, .ply, .obj, .3mf, .stl.dcm)</source>
        <translation>no es un archivo de malla (.stl, .vtp, .ply, .obj, .3mf, .stl.dcm)</translation>
    </message>
    <message>
        <source>it is encrypted</source>
        <translation>está cifrado</translation>
    </message>
    <message>
        <source>it needs an extension of {format} that is not supported ({extension})</source>
        <translation>necesita una extensión de {format} que no se admite ({extension})</translation>
    </message>
    <message>
        <source>an object begins with one surface or is one, not both.</source>
        <translation>Un objeto comienza con una superficie o es una, pero no ambas cosas.</translation>
    </message>
    <message>
        <source>The balloon weight must be a number above 0.</source>
        <translation>El peso del globo debe ser un número mayor que 0.</translation>
    </message>
    <message>
        <source>The curvature weight must be a number of at least 0.</source>
        <translation>El peso de la curvatura debe ser un número igual o mayor que 0.</translation>
    </message>
    <message>
        <source>The number of iterations must not be negative.</source>
        <translation>El número de iteraciones no puede ser negativo.</translation>
    </message>
    <message>
        <source>The number of threads must be between 0 and 1024.</source>
        <translation>El número de hilos debe estar entre 0 y 1024.</translation>
    </message>
    <message>
        <source>The smoothing must be at least 0 mm.</source>
        <translation>El suavizado debe ser de al menos 0 mm.</translation>
    </message>
    <message>
        <source>The edge length must be above 0 mm.</source>
        <translation>La longitud de arista debe ser mayor que 0 mm.</translation>
    </message>
    <message>
        <source>The smoothing of {given_mm} mm is too large for a volume whose longest side is {longest_mm} mm: at most {most_mm} mm.</source>
        <translation>El suavizado de {given_mm} mm es demasiado grande para un volumen cuyo lado más largo mide {longest_mm} mm: como máximo {most_mm} mm.</translation>
    </message>
    <message>
        <source>The edge length of {given_mm} mm is too large for a volume whose longest side is {longest_mm} mm: at most {most_mm} mm.</source>
        <translation>La longitud de arista de {given_mm} mm es demasiado grande para un volumen cuyo lado más largo mide {longest_mm} mm: como máximo {most_mm} mm.</translation>
    </message>
    <message>
        <source>The number of components must be at least 1.</source>
        <translation>El número de componentes debe ser al menos 1.</translation>
    </message>
    <message>
        <source>The genus must be at least 0.</source>
        <translation>El género debe ser al menos 0.</translation>
    </message>
    <message>
        <source>The wall at {place} has no radius above 0 mm.</source>
        <translation>La barrera en {place} no tiene un radio mayor que 0 mm.</translation>
    </message>
    <message>
        <source>The wall disc at {place} has no radius above 0 mm.</source>
        <translation>El disco de barrera en {place} no tiene un radio mayor que 0 mm.</translation>
    </message>
    <message>
        <source>The wall disc at {place} mm has a normal of no length.</source>
        <translation>El disco de barrera en {place} mm tiene una normal de longitud nula.</translation>
    </message>
    <message>
        <source>The label map of the walls has not been read.</source>
        <translation>El mapa de etiquetas de las barreras no se ha leído.</translation>
    </message>
    <message>
        <source>The surface to begin with, {file}, has not been read.</source>
        <translation>La superficie inicial, {file}, no se ha leído.</translation>
    </message>
    <message>
        <source>A veto needs an iteration of at least 1 and a place.</source>
        <translation>Un veto necesita una iteración de al menos 1 y un lugar.</translation>
    </message>
    <message>
        <source>Iteration {iteration:0f} is an edit: there is nothing that a veto could forbid.</source>
        <translation>La iteración {iteration:0f} es una edición: no hay nada que un veto pueda prohibir.</translation>
    </message>
    <message>
        <source>The pin at {place} has no radius above 0 mm.</source>
        <translation>La fijación en {place} no tiene un radio mayor que 0 mm.</translation>
    </message>
    <message>
        <source>The pin at {place} mm has an iteration below 0.</source>
        <translation>La fijación en {place} mm tiene una iteración menor que 0.</translation>
    </message>
    <message>
        <source>An edit needs an iteration of at least 1 and a place.</source>
        <translation>Una edición necesita una iteración de al menos 1 y un lugar.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} has a number that is not finite.</source>
        <translation>La edición de la iteración {iteration:0f} tiene un número que no es finito.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} has no radius above 0 mm.</source>
        <translation>La edición de la iteración {iteration:0f} no tiene un radio mayor que 0 mm.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} has a radius below 0 mm.</source>
        <translation>La edición de la iteración {iteration:0f} tiene un radio menor que 0 mm.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} has a normal of no length.</source>
        <translation>La edición de la iteración {iteration:0f} tiene una normal de longitud nula.</translation>
    </message>
    <message>
        <source>There are two edits of iteration {iteration:0f}: a step can be one only.</source>
        <translation>Hay dos ediciones de la iteración {iteration:0f}: un paso solo puede ser una.</translation>
    </message>
    <message>
        <source>The veto of iteration {iteration:0f} has nothing to forbid: the growth ended at iteration {now:0f}.</source>
        <translation>El veto de la iteración {iteration:0f} no tiene nada que prohibir: el crecimiento terminó en la iteración {now:0f}.</translation>
    </message>
    <message>
        <source>The pin {pin} holds nothing: the growth ended at iteration {now:0f}.</source>
        <translation>La fijación {pin} no sujeta nada: el crecimiento terminó en la iteración {now:0f}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} is never made: the growth ended at iteration {now:0f}.</source>
        <translation>La edición de la iteración {iteration:0f} no se hace nunca: el crecimiento terminó en la iteración {now:0f}.</translation>
    </message>
    <message>
        <source>The surface intersects itself in single precision: the volume lies too far from the origin.</source>
        <translation>La superficie se interseca consigo misma en precisión simple: el volumen está demasiado lejos del origen.</translation>
    </message>
    <message>
        <source>{sampling_mm:4g} mm between samples would take more than {most:0f} samples of these surfaces.</source>
        <translation>{sampling_mm:4g} mm entre muestras exigirían más de {most:0f} muestras de estas superficies.</translation>
    </message>
    <message>
        <source>{file}: it {cause}.</source>
        <translation>{file}: {cause}.</translation>
    </message>
    <message>
        <source>the {format} file is damaged ({cause})</source>
        <translation>el archivo {format} está dañado ({cause})</translation>
    </message>
    <message>
        <source>{part} is missing</source>
        <translation>falta {part}</translation>
    </message>
    <message>
        <source>object {object:0f} is missing</source>
        <translation>falta el objeto {object:0f}</translation>
    </message>
    <message>
        <source>object {object:0f} holds itself</source>
        <translation>el objeto {object:0f} se contiene a sí mismo</translation>
    </message>
    <message>
        <source>two objects {object:0f}</source>
        <translation>dos objetos con el número {object:0f}</translation>
    </message>
    <message>
        <source>an object without a number</source>
        <translation>un objeto sin número</translation>
    </message>
    <message>
        <source>too deeply nested components</source>
        <translation>componentes anidados a demasiada profundidad</translation>
    </message>
    <message>
        <source>more than {most:0f} objects and components</source>
        <translation>más de {most:0f} objetos y componentes</translation>
    </message>
    <message>
        <source>a component or an item without an object</source>
        <translation>un componente o un elemento sin objeto</translation>
    </message>
    <message>
        <source>a transform that is not twelve numbers</source>
        <translation>una transformación que no consta de doce números</translation>
    </message>
    <message>
        <source>unit {unit}</source>
        <translation>unidad {unit}</translation>
    </message>
    <message>
        <source>the compression of {part}</source>
        <translation>la compresión de {part}</translation>
    </message>
    <message>
        <source>the size of {part}</source>
        <translation>el tamaño de {part}</translation>
    </message>
    <message>
        <source>{cause} in line {line:0f} of {part}</source>
        <translation>{cause} en la línea {line:0f} de {part}</translation>
    </message>
    <message>
        <source>XML: {reason}</source>
        <translation>error de XML: {reason}</translation>
    </message>
    <message>
        <source>too deeply nested XML</source>
        <translation>XML anidado a demasiada profundidad</translation>
    </message>
    <message>
        <source>a document type declaration</source>
        <translation>una declaración de tipo de documento</translation>
    </message>
    <message>
        <source>a tag of more than a megabyte</source>
        <translation>una etiqueta de más de un megabyte</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un número</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>una lista</translation>
    </message>
    <message>
        <source>it has no field '{field}'.</source>
        <translation>le falta el campo «{field}».</translation>
    </message>
    <message>
        <source>this version does not know its field '{field}'.</source>
        <translation>esta versión no conoce su campo «{field}».</translation>
    </message>
    <message>
        <source>its field '{field}' is not a JSON object.</source>
        <translation>su campo «{field}» no es un objeto JSON.</translation>
    </message>
    <message>
        <source>its field '{field}' is not a list.</source>
        <translation>su campo «{field}» no es una lista.</translation>
    </message>
    <message>
        <source>its field '{field}' must have {needed:0f} entries; it has {count:0f}.</source>
        <translation>su campo «{field}» debe tener {needed:0f} elementos; tiene {count:0f}.</translation>
    </message>
    <message>
        <source>its field '{field}' is not a text.</source>
        <translation>su campo «{field}» no es un texto.</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, neither true nor false.</source>
        <translation>su campo «{field}» es {value}, ni true ni false.</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, not a number.</source>
        <translation>su campo «{field}» es {value}, que no es un número.</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, not a whole number in range.</source>
        <translation>su campo «{field}» es {value}, que no es un número entero dentro de los límites.</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, and must be at least {least}.</source>
        <translation>su campo «{field}» es {value} y debe ser al menos {least}.</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, and must be above {least}.</source>
        <translation>su campo «{field}» es {value} y debe ser mayor que {least}.</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, and must be from {least:0f} to {most:0f}.</source>
        <translation>su campo «{field}» es {value} y debe estar entre {least:0f} y {most:0f}.</translation>
    </message>
    <message>
        <source>its field '{field}' is '{value}', a word that this version does not know.</source>
        <translation>su campo «{field}» es «{value}», una palabra que esta versión no conoce.</translation>
    </message>
    <message>
        <source>its field '{field}' is empty.</source>
        <translation>su campo «{field}» está vacío.</translation>
    </message>
    <message>
        <source>its field '{field}' is no range: its lower end is above its upper end.</source>
        <translation>su campo «{field}» no es un intervalo: su extremo inferior está por encima del superior.</translation>
    </message>
    <message>
        <source>its field '{field}' is not above that of the entry before it.</source>
        <translation>su campo «{field}» no es mayor que el del elemento anterior.</translation>
    </message>
    <message>
        <source>its field '{field}' is 0, which is no label.</source>
        <translation>su campo «{field}» es 0, que no es una etiqueta.</translation>
    </message>
    <message>
        <source>its field '{field}' is a vector of no length.</source>
        <translation>su campo «{field}» es un vector de longitud nula.</translation>
    </message>
    <message>
        <source>its field '{field}' cannot name an object: a name has 1 to {most:0f} characters, no control characters and none of {separators}.</source>
        <translation>su campo «{field}» no puede nombrar un objeto: un nombre tiene de 1 a {most:0f} caracteres, sin caracteres de control ni ninguno de {separators}.</translation>
    </message>
    <message>
        <source>its field '{field}' has a code that is empty, too long, or holds what separates codes.</source>
        <translation>su campo «{field}» tiene un código vacío, demasiado largo o que contiene lo que separa los códigos.</translation>
    </message>
    <message>
        <source>its field '{field}' is a name that cannot be written into files.</source>
        <translation>su campo «{field}» es un nombre que no se puede escribir en archivos.</translation>
    </message>
    <message>
        <source>it holds a number that is too large.</source>
        <translation>contiene un número demasiado grande.</translation>
    </message>
    <message>
        <source>several objects cannot be carried over time.</source>
        <translation>no se pueden llevar varios objetos a lo largo del tiempo.</translation>
    </message>
    <message>
        <source>a corrected frame begins with the surface of the frame beside it, not with that of a file.</source>
        <translation>un fotograma corregido empieza con la superficie del fotograma vecino, no con la de un archivo.</translation>
    </message>
    <message>
        <source>{file} holds {objects:0f} objects, where one is needed; handlebody-cli replay makes them all.</source>
        <translation>{file} contiene {objects:0f} objetos, donde se necesita uno; handlebody-cli replay los hace todos.</translation>
    </message>
    <message>
        <source>{file} is not needed: the session has no walls of a label map.</source>
        <translation>{file} no hace falta: la sesión no tiene barreras de un mapa de etiquetas.</translation>
    </message>
    <message>
        <source>{file} is not needed: nothing in the session begins with a surface.</source>
        <translation>{file} no hace falta: nada en la sesión empieza con una superficie.</translation>
    </message>
    <message>
        <source>{file}: the session does not keep which file is meant, so that only one can be; {other} is given, too.</source>
        <translation>{file}: la sesión no guarda a qué archivo se refiere, así que solo puede ser uno; también se da {other}.</translation>
    </message>
    <message>
        <source>{file}: a series is chosen in DICOM alone, this is {format}.</source>
        <translation>{file}: una serie solo se elige en DICOM, esto es {format}.</translation>
    </message>
    <message>
        <source>{file}: a spacing is not above 0.</source>
        <translation>{file}: un espaciado no es mayor que 0.</translation>
    </message>
    <message>
        <source>{file}: meshes are written as .stl, .vtp, .ply or .obj.</source>
        <translation>{file}: las mallas se escriben como .stl, .vtp, .ply u .obj.</translation>
    </message>
    <message>
        <source>{file}: a mesh with values is written as .vtp.</source>
        <translation>{file}: una malla con valores se escribe como .vtp.</translation>
    </message>
    <message>
        <source>{file}: volumes are written as .nii.gz, .nii, .nrrd or .mha.</source>
        <translation>{file}: los volúmenes se escriben como .nii.gz, .nii, .nrrd o .mha.</translation>
    </message>
    <message>
        <source>{file}: 4D volumes are written as .nii.gz, .nii or .nrrd.</source>
        <translation>{file}: los volúmenes 4D se escriben como .nii.gz, .nii o .nrrd.</translation>
    </message>
    <message>
        <source>a volume to be written needs at least two voxels along each axis</source>
        <translation>un volumen que se escribe necesita al menos dos vóxeles a lo largo de cada eje</translation>
    </message>
    <message>
        <source>VTK wrote no scene of it</source>
        <translation>VTK no escribió ninguna escena de ello</translation>
    </message>
    <message>
        <source>no folder for temporary files can be made: {cause}.</source>
        <translation>no se puede crear una carpeta para archivos temporales: {cause}.</translation>
    </message>
    <message>
        <source>what the clicks mean there agrees to {percent:0f} % (Dice) with the object of frame {from_frame} as the images move it; the latter was taken</source>
        <translation>lo que indican los clics allí coincide en un {percent:0f} % (Dice) con el objeto del fotograma {from_frame} tal como lo mueven las imágenes; se tomó este último</translation>
    </message>
    <message>
        <source>what the clicks mean there fails ({cause}); the object of frame {from_frame} as the images move it was taken</source>
        <translation>lo que indican los clics allí falla ({cause}); se tomó el objeto del fotograma {from_frame} tal como lo mueven las imágenes</translation>
    </message>
    <message>
        <source>it was carried from frame {from_frame}, whose surface failed</source>
        <translation>la superficie viene del fotograma {from_frame}, donde falló</translation>
    </message>
    <message>
        <source>{file} cannot be used as walls: it has {frames:0f} time points, and walls are the same at all of them.</source>
        <translation>{file} no puede servir de barreras: tiene {frames:0f} instantes, y las barreras son las mismas en todos.</translation>
    </message>
    <message>
        <source>There are {frames:0f} time points; the first one is used.</source>
        <translation>Hay {frames:0f} instantes; se usa el primero.</translation>
    </message>
    <message>
        <source>The header does not say where the first voxel lies; it is taken to lie at 0, 0, 0.</source>
        <translation>La cabecera no dice dónde está el primer vóxel; se supone 0, 0, 0.</translation>
    </message>
    <message>
        <source>{object} has parts that lie where they bound nothing, as one does that is inside out: it has no volume, and there is no Dice coefficient.</source>
        <translation>{object} tiene partes que no delimitan nada donde están, como una vuelta del revés: no hay volumen ni coeficiente de Dice.</translation>
    </message>
    <message>
        <source>The header does not state the distance of the slices: {spacing_mm:4g} mm are taken, the least between its frames, though a slice is {thickness_mm:4g} mm thick. Slices may be left out.</source>
        <translation>La cabecera no indica la distancia entre los cortes: se toman {spacing_mm:4g} mm, la menor entre sus imágenes, aunque un corte tiene {thickness_mm:4g} mm de espesor. Puede que se hayan omitido cortes.</translation>
    </message>
    <message>
        <source>the veto of iteration {iteration:0f} forbids nothing: the mesh is that of iteration {mesh_iteration:0f}</source>
        <translation>el veto de la iteración {iteration:0f} no prohíbe nada: la malla es la de la iteración {mesh_iteration:0f}</translation>
    </message>
    <message>
        <source>the edit of iteration {iteration:0f} is not made: the mesh is that of iteration {mesh_iteration:0f}</source>
        <translation>la edición de la iteración {iteration:0f} no se ha hecho: la malla es la de la iteración {mesh_iteration:0f}</translation>
    </message>
    <message>
        <source>The volume of the surface, {volume_ml:4g} ml, lies outside of those of all runs with clicks, smoothing and noise a little different, {least_ml:4g} to {most_ml:4g} ml: they may have found another object</source>
        <translation>El volumen de la superficie, {volume_ml:4g} ml, queda fuera de los de todas las repeticiones con clics, suavizado y ruido un poco distintos, {least_ml:4g} a {most_ml:4g} ml: quizá hayan encontrado otro objeto</translation>
    </message>
    <message>
        <source>The sensitivity cannot be told of a surface that was given as it is: there is no growth to repeat.</source>
        <translation>No se puede indicar la sensibilidad de una superficie dada tal cual: no hay ningún crecimiento que repetir.</translation>
    </message>
    <message>
        <source>the clicks may mean fewer objects than {asked:0f}, which is the one that was asked for: number {taken:0f}, the last of them, was taken</source>
        <translation>los clics pueden designar menos objetos que {asked:0f}, el número pedido: se ha tomado el número {taken:0f}, el último de ellos</translation>
    </message>
    <message>
        <source>The mesh encloses {mesh_ml:4g} ml, the voxels that it was made of {voxels_ml:4g} ml ({percent:0f} %): they are too few, or too narrow, for their shape to be kept.</source>
        <translation>La malla encierra {mesh_ml:4g} ml, los vóxeles de los que se hizo {voxels_ml:4g} ml ({percent:0f} %): son demasiado pocos o estrechos para conservar su forma.</translation>
    </message>
    <message>
        <source>The edges of the mesh are {median_mm:3g} mm long in the median, not {asked_mm:4g} mm as was asked for: with such edges it would leave the voxels or intersect itself.</source>
        <translation>Las aristas de la malla miden {median_mm:3g} mm de mediana, no {asked_mm:4g} mm como se pidió: con tales aristas se apartaría de los vóxeles o se cortaría a sí misma.</translation>
    </message>
    <message>
        <source>the surface reaches {distance_mm:1f} mm into the ball of {radius_mm:1f} mm around the click outside of the object at {place:1f} mm: the image or other clicks speak against it</source>
        <translation>la superficie penetra {distance_mm:1f} mm en la bola de {radius_mm:1f} mm alrededor del punto exterior en {place:1f} mm: la imagen u otros clics lo contradicen</translation>
    </message>
    <message>
        <source>The seed at {place:1f} mm lies in the ball of {radius_mm:1f} mm around the click outside of the object at {outside:1f} mm: they contradict each other.</source>
        <translation>La semilla en {place:1f} mm está en la bola de {radius_mm:1f} mm alrededor del punto exterior en {outside:1f} mm: se contradicen.</translation>
    </message>
    <message>
        <source>The click outside of the object at {outside:1f} mm holds the deepest place of the surface to begin with, which stands for the object: give a seed, or another surface.</source>
        <translation>El punto exterior en {outside:1f} mm contiene el punto más profundo de la superficie inicial, que representa el objeto: dé una semilla u otra superficie.</translation>
    </message>
    <message>
        <source>has no effect on an object that was given: its surface stays as it is, and nothing grows.</source>
        <translation>no tiene efecto en un objeto dado: su superficie queda como está, y nada crece.</translation>
    </message>
    <message>
        <source>has no effect with a range, by which the intensities alone say what the object is: leave one of them out.</source>
        <translation>no tiene efecto con un rango, en el que solo las intensidades dicen qué es el objeto: omita uno de los dos.</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies over the surface that was given, or within it, and that surface stays as it is.</source>
        <translation>La pared en {place} mm está sobre la superficie dada, o dentro de ella, y esa superficie queda como está.</translation>
    </message>
    <message>
        <source>object '{object}' has no seed and is left out.</source>
        <translation>el objeto «{object}» no tiene semilla y se omite.</translation>
    </message>
    <message>
        <source>{session} was made by version {version}; this is {here}, and the mesh may differ.</source>
        <translation>{session} se creó con la versión {version}; esta es {here}, y la malla puede ser distinta.</translation>
    </message>
    <message>
        <source>the session carries the surface through other frames, too, and these figures are of frame {frame:0f} alone; handlebody-cli replay writes those of all.</source>
        <translation>la sesión lleva la superficie también por otros fotogramas, y estas cifras son solo del fotograma {frame:0f}; handlebody-cli replay escribe las de todos.</translation>
    </message>
    <message>
        <source>has no effect: it says how a label becomes a surface, and {file} is a mesh.</source>
        <translation>no tiene efecto: dice cómo una etiqueta se convierte en superficie, y {file} es una malla.</translation>
    </message>
    <message>
        <source>{file} has {count:0f} components, and is to have no more than {most:0f}.</source>
        <translation>{file} tiene {count:0f} componentes y no debe tener más de {most:0f}.</translation>
    </message>
    <message>
        <source>{file} has {count:0f} handles or tunnels, and is to have no more than {most:0f}.</source>
        <translation>{file} tiene {count:0f} asas o túneles y no debe tener más de {most:0f}.</translation>
    </message>
</context>
<context>
    <name>Sentences</name>
    <message>
        <source> More in the step Open.</source>
        <translation> Más en el paso Abrir.</translation>
    </message>
</context>
<context>
    <name>SliceView</name>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagital</translation>
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
        <translation>%1 mm o más</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>outside: %1</source>
        <translation>fuera: %1</translation>
    </message>
    <message>
        <source>inside: %1</source>
        <translation>dentro: %1</translation>
    </message>
    <message>
        <source>on the reference: 0 mm</source>
        <translation>sobre la referencia: 0 mm</translation>
    </message>
</context>
<context>
    <name>handlebody::app::Screenshot</name>
    <message>
        <source>There is no seed to grow from: open a session.</source>
        <translation>No hay semilla desde la que crecer: abra una sesión.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>No se puede escribir %1.</translation>
    </message>
    <message>
        <source>There is no event at iteration %1, and so no stage of it.</source>
        <translation>No hay ningún evento en la iteración %1 y, por tanto, ninguna etapa suya.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>No hay memoria suficiente para esto.</translation>
    </message>
    <message>
        <source>Something went wrong that has no name.</source>
        <translation>Algo sin nombre salió mal.</translation>
    </message>
    <message>
        <source>There is no surface yet: grow one first.</source>
        <translation>Aún no hay superficie: haga crecer una primero.</translation>
    </message>
    <message>
        <source>There is no centre line in “%1”: %2.</source>
        <translation>No hay línea central en «%1»: %2.</translation>
    </message>
    <message>
        <source>The first place lies in none of the objects.</source>
        <translation>El primer lugar no está en ninguno de los objetos.</translation>
    </message>
    <message>
        <source>Slice %1 of %2</source>
        <translation>Corte %1 de %2</translation>
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
        <translation>menos del 1 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>not compared with the image</source>
        <translation>sin comparar con la imagen</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>sin comparar</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>en movimiento</translation>
    </message>
    <message>
        <source>settled</source>
        <translation>en reposo</translation>
    </message>
    <message>
        <source>new handle</source>
        <translation>asa nueva</translation>
    </message>
    <message>
        <source>colliding</source>
        <translation>en colisión</translation>
    </message>
    <message>
        <source>no edge in the image: %1 of the surface</source>
        <translation>sin borde en la imagen: %1 de la superficie</translation>
    </message>
    <message>
        <source>edge in the image</source>
        <translation>borde en la imagen</translation>
    </message>
    <message>
        <source>no edge: %1</source>
        <translation>sin borde: %1</translation>
    </message>
    <message>
        <source>border of the volume</source>
        <translation>borde del volumen</translation>
    </message>
    <message>
        <source>pinned</source>
        <translation>fijado</translation>
    </message>
    <message>
        <source>colliding triangles</source>
        <translation>triángulos en colisión</translation>
    </message>
    <message>
        <source>vertices that are taken out</source>
        <translation>vértices que se quitan</translation>
    </message>
    <message>
        <source>boundary polygons</source>
        <translation>polígonos de borde</translation>
    </message>
    <message>
        <source>handle</source>
        <translation>asa</translation>
    </message>
    <message>
        <source>closed mesh</source>
        <translation>malla cerrada</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Radio del pincel</translation>
    </message>
    <message>
        <source>The brush is a ball, the same for walls and for the surface; Ctrl+wheel changes it while it is on</source>
        <translation>El pincel es una bola, la misma para las barreras y la superficie; Ctrl+rueda la cambia mientras está activo</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Open file…</source>
        <translation>&amp;Abrir archivo…</translation>
    </message>
    <message>
        <source>Open &amp;folder…</source>
        <translation>Abrir &amp;carpeta…</translation>
    </message>
    <message>
        <source>Open a folder with a DICOM series</source>
        <translation>Abrir una carpeta con una serie DICOM</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>Guardar &amp;sesión</translation>
    </message>
    <message>
        <source>Save volume reference, seeds and parameters, to go on later or to replay</source>
        <translation>Guardar la referencia del volumen, las semillas y los parámetros, para continuar o repetir más tarde</translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation>&amp;Guardar sesión como…</translation>
    </message>
    <message>
        <source>Save the session under another name</source>
        <translation>Guardar la sesión con otro nombre</translation>
    </message>
    <message>
        <source>&amp;Export result…</source>
        <translation>&amp;Exportar resultado…</translation>
    </message>
    <message>
        <source>Write the surface or its label map to a file</source>
        <translation>Escribir la superficie o su mapa de etiquetas en un archivo</translation>
    </message>
    <message>
        <source>Export repor&amp;t…</source>
        <translation>Exportar &amp;informe…</translation>
    </message>
    <message>
        <source>Write parameters, numbers and events as JSON</source>
        <translation>Escribir parámetros, números y eventos como JSON</translation>
    </message>
    <message>
        <source>Export &amp;picture…</source>
        <translation>Ex&amp;portar imagen…</translation>
    </message>
    <message>
        <source>Write what the views show as PNG</source>
        <translation>Escribir como PNG lo que muestran las vistas</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Sa&amp;lir</translation>
    </message>
    <message>
        <source>Close the program</source>
        <translation>Cerrar el programa</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Deshacer el último cambio</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Do again what was taken back</source>
        <translation>Volver a hacer lo deshecho</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>&amp;Layout</source>
        <translation>&amp;Disposición</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>&amp;Paso</translation>
    </message>
    <message>
        <source>3D &amp;camera</source>
        <translation>&amp;Cámara 3D</translation>
    </message>
    <message>
        <source>All &amp;four</source>
        <translation>&amp;Las cuatro</translation>
    </message>
    <message>
        <source>Axial, 3D, coronal and sagittal view together</source>
        <translation>Vistas axial, 3D, coronal y sagital juntas</translation>
    </message>
    <message>
        <source>&amp;Axial only</source>
        <translation>Solo &amp;axial</translation>
    </message>
    <message>
        <source>Only the axial slice</source>
        <translation>Solo el corte axial</translation>
    </message>
    <message>
        <source>&amp;Coronal only</source>
        <translation>Solo &amp;coronal</translation>
    </message>
    <message>
        <source>Only the coronal slice</source>
        <translation>Solo el corte coronal</translation>
    </message>
    <message>
        <source>&amp;Sagittal only</source>
        <translation>&amp;Solo sagital</translation>
    </message>
    <message>
        <source>Only the sagittal slice</source>
        <translation>Solo el corte sagital</translation>
    </message>
    <message>
        <source>&amp;3D only</source>
        <translation>Solo &amp;3D</translation>
    </message>
    <message>
        <source>Only the surface in 3D</source>
        <translation>Solo la superficie en 3D</translation>
    </message>
    <message>
        <source>1 &amp;Open</source>
        <translation>&amp;1 Abrir</translation>
    </message>
    <message>
        <source>Choose a volume</source>
        <translation>Elegir un volumen</translation>
    </message>
    <message>
        <source>2 &amp;Seed</source>
        <translation>2 &amp;Semillas</translation>
    </message>
    <message>
        <source>Place seeds in the object</source>
        <translation>Poner semillas en el objeto</translation>
    </message>
    <message>
        <source>3 &amp;Tune</source>
        <translation>&amp;3 Ajustar</translation>
    </message>
    <message>
        <source>Set range and forces</source>
        <translation>Fijar intervalo y fuerzas</translation>
    </message>
    <message>
        <source>4 &amp;Grow</source>
        <translation>&amp;4 Crecer</translation>
    </message>
    <message>
        <source>Grow the surface and watch it</source>
        <translation>Hacer crecer la superficie y observarla</translation>
    </message>
    <message>
        <source>5 &amp;Correct</source>
        <translation>5 &amp;Corregir</translation>
    </message>
    <message>
        <source>Walls, and what is held back: mend what has grown wrong</source>
        <translation>Barreras y lo retenido: arreglar lo que creció mal</translation>
    </message>
    <message>
        <source>6 &amp;Export</source>
        <translation>6 &amp;Exportar</translation>
    </message>
    <message>
        <source>Write the results</source>
        <translation>Escribir los resultados</translation>
    </message>
    <message>
        <source>&amp;Reset views</source>
        <translation>&amp;Restablecer vistas</translation>
    </message>
    <message>
        <source>Whole slices, camera from the front</source>
        <translation>Cortes enteros, cámara de frente</translation>
    </message>
    <message>
        <source>From &amp;above (superior)</source>
        <translation>Desde &amp;arriba (superior)</translation>
    </message>
    <message>
        <source>3D view: look from superior; with the 3D view in focus</source>
        <translation>Vista 3D: mirar desde superior; con el foco en la vista 3D</translation>
    </message>
    <message>
        <source>From the &amp;front (anterior)</source>
        <translation>&amp;Desde delante (anterior)</translation>
    </message>
    <message>
        <source>3D view: look from anterior; with the 3D view in focus</source>
        <translation>Vista 3D: mirar desde anterior; con el foco en la vista 3D</translation>
    </message>
    <message>
        <source>From the &amp;left</source>
        <translation>Desde &amp;la izquierda</translation>
    </message>
    <message>
        <source>3D view: look from the patient's left; with the 3D view in focus</source>
        <translation>Vista 3D: mirar desde la izquierda del paciente; con el foco en la vista 3D</translation>
    </message>
    <message>
        <source>Slices &amp;in 3D</source>
        <translation>Cortes &amp;en 3D</translation>
    </message>
    <message>
        <source>Show the three slices in the 3D view</source>
        <translation>Mostrar los tres cortes en la vista 3D</translation>
    </message>
    <message>
        <source>Walls a&amp;nd pins</source>
        <translation>&amp;Barreras y fijaciones</translation>
    </message>
    <message>
        <source>Draw the active object's walls, and what of its surface is pinned</source>
        <translation>Dibujar las barreras del objeto activo y lo fijado de su superficie</translation>
    </message>
    <message>
        <source>CT pr&amp;esets</source>
        <translation>Ajustes de &amp;TC</translation>
    </message>
    <message>
        <source>C&amp;olour map</source>
        <translation>&amp;Mapa de colores</translation>
    </message>
    <message>
        <source>Sur&amp;face</source>
        <translation>&amp;Superficie</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>Apar&amp;iencia</translation>
    </message>
    <message>
        <source>Langua&amp;ge</source>
        <translation>Idi&amp;oma</translation>
    </message>
    <message>
        <source>Language of the texts and numbers in the window, from the next start on</source>
        <translation>Idioma de los textos y números de la ventana, desde el próximo inicio</translation>
    </message>
    <message>
        <source>&amp;Window and level by dragging</source>
        <translation>&amp;Ventana y nivel arrastrando</translation>
    </message>
    <message>
        <source>Drag in a slice: sideways for the window (contrast), up and down for the level (brightness)</source>
        <translation>Arrastrar en un corte: a los lados para la ventana (contraste), arriba y abajo para el nivel (brillo)</translation>
    </message>
    <message>
        <source>Au&amp;to window</source>
        <translation>Ve&amp;ntana automática</translation>
    </message>
    <message>
        <source>Window and level from the intensities of the volume</source>
        <translation>Ventana y nivel según las intensidades del volumen</translation>
    </message>
    <message>
        <source>&amp;Soft tissue (400 / 40 HU)</source>
        <translation>&amp;Tejidos blandos (400 / 40 HU)</translation>
    </message>
    <message>
        <source>Window 400, level 40</source>
        <translation>Ventana 400, nivel 40</translation>
    </message>
    <message>
        <source>&amp;Lung (1500 / −600 HU)</source>
        <translation>&amp;Pulmón (1500 / −600 HU)</translation>
    </message>
    <message>
        <source>Window 1500, level −600</source>
        <translation>Ventana 1500, nivel −600</translation>
    </message>
    <message>
        <source>&amp;Bone (1800 / 400 HU)</source>
        <translation>&amp;Hueso (1800 / 400 HU)</translation>
    </message>
    <message>
        <source>Window 1800, level 400</source>
        <translation>Ventana 1800, nivel 400</translation>
    </message>
    <message>
        <source>B&amp;rain (80 / 40 HU)</source>
        <translation>&amp;Cerebro (80 / 40 HU)</translation>
    </message>
    <message>
        <source>Window 80, level 40</source>
        <translation>Ventana 80, nivel 40</translation>
    </message>
    <message>
        <source>&amp;Vessels (600 / 170 HU)</source>
        <translation>&amp;Vasos (600 / 170 HU)</translation>
    </message>
    <message>
        <source>Window 600, level 170</source>
        <translation>Ventana 600, nivel 170</translation>
    </message>
    <message>
        <source>&amp;Grey</source>
        <translation>&amp;Gris</translation>
    </message>
    <message>
        <source>Black to white</source>
        <translation>De negro a blanco</translation>
    </message>
    <message>
        <source>&amp;Inverted</source>
        <translation>&amp;Invertido</translation>
    </message>
    <message>
        <source>White to black</source>
        <translation>De blanco a negro</translation>
    </message>
    <message>
        <source>&amp;Hot</source>
        <translation>&amp;Cálido</translation>
    </message>
    <message>
        <source>Black over red and yellow to white</source>
        <translation>De negro a blanco pasando por rojo y amarillo</translation>
    </message>
    <message>
        <source>&amp;Contrast-enhancing</source>
        <translation>&amp;Realce de contraste</translation>
    </message>
    <message>
        <source>Dark intensities spread over many colours, for ultrasound</source>
        <translation>Intensidades oscuras repartidas en muchos colores, para ecografía</translation>
    </message>
    <message>
        <source>&amp;Plain</source>
        <translation>&amp;Simple</translation>
    </message>
    <message>
        <source>One colour, shaded</source>
        <translation>Un color, sombreado</translation>
    </message>
    <message>
        <source>With &amp;edges</source>
        <translation>&amp;Con aristas</translation>
    </message>
    <message>
        <source>The triangles' edges are drawn</source>
        <translation>Se dibujan las aristas de los triángulos</translation>
    </message>
    <message>
        <source>By &amp;state</source>
        <translation>&amp;Por estado</translation>
    </message>
    <message>
        <source>Moving, settled, new handle and colliding faces in their colours</source>
        <translation>Caras en movimiento, en reposo, nuevas y en colisión con sus colores</translation>
    </message>
    <message>
        <source>Support by the &amp;image</source>
        <translation>Apoyo de la &amp;imagen</translation>
    </message>
    <message>
        <source>Blue where the image shows no edge, in 3D and on the slices</source>
        <translation>Azul donde la imagen no muestra borde, en 3D y en los cortes</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Como el &amp;sistema</translation>
    </message>
    <message>
        <source>Light or dark as the desktop</source>
        <translation>Claro u oscuro como el escritorio</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Claro</translation>
    </message>
    <message>
        <source>Dark text on light ground</source>
        <translation>Texto oscuro sobre fondo claro</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Oscuro</translation>
    </message>
    <message>
        <source>Light text on dark ground</source>
        <translation>Texto claro sobre fondo oscuro</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Panta&amp;lla completa</translation>
    </message>
    <message>
        <source>The window fills the screen</source>
        <translation>La ventana llena la pantalla</translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation>&amp;Semilla</translation>
    </message>
    <message>
        <source>&amp;Add at the crosshair</source>
        <translation>&amp;Añadir en la cruz</translation>
    </message>
    <message>
        <source>Place a seed where the crosshair is</source>
        <translation>Poner una semilla donde está la cruz</translation>
    </message>
    <message>
        <source>Add &amp;outside of the object</source>
        <translation>Añadir fuera del &amp;objeto</translation>
    </message>
    <message>
        <source>Place a click outside of the object where the crosshair is</source>
        <translation>Poner un punto exterior donde está la cruz</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Eliminar</translation>
    </message>
    <message>
        <source>Delete the selected seed or click outside</source>
        <translation>Eliminar la semilla o el punto exterior elegido</translation>
    </message>
    <message>
        <source>&amp;Larger radius</source>
        <translation>&amp;Radio mayor</translation>
    </message>
    <message>
        <source>Radius of the selected seed half a voxel larger</source>
        <translation>Radio de la semilla elegida medio vóxel mayor</translation>
    </message>
    <message>
        <source>&amp;Smaller radius</source>
        <translation>Radio &amp;menor</translation>
    </message>
    <message>
        <source>Radius of the selected seed half a voxel smaller</source>
        <translation>Radio de la semilla elegida medio vóxel menor</translation>
    </message>
    <message>
        <source>Select the &amp;next</source>
        <translation>Elegir &amp;la siguiente</translation>
    </message>
    <message>
        <source>Select the next seed and move the crosshair there</source>
        <translation>Elegir la semilla siguiente y llevar allí la cruz</translation>
    </message>
    <message>
        <source>S&amp;maller object</source>
        <translation>O&amp;bjeto menor</translation>
    </message>
    <message>
        <source>Take the next smaller of the objects that the clicks may mean</source>
        <translation>Tomar el siguiente menor de los objetos posibles</translation>
    </message>
    <message>
        <source>La&amp;rger object</source>
        <translation>Ob&amp;jeto mayor</translation>
    </message>
    <message>
        <source>Take the next larger of the objects that the clicks may mean</source>
        <translation>Tomar el siguiente mayor de los objetos posibles</translation>
    </message>
    <message>
        <source>&amp;Grow</source>
        <translation>&amp;Crecimiento</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Iniciar</translation>
    </message>
    <message>
        <source>Grow the surface, or pause</source>
        <translation>Hacer crecer la superficie, o pausar</translation>
    </message>
    <message>
        <source>One step &amp;forward</source>
        <translation>&amp;Un paso adelante</translation>
    </message>
    <message>
        <source>One iteration forward</source>
        <translation>Una iteración adelante</translation>
    </message>
    <message>
        <source>One step &amp;back</source>
        <translation>Un &amp;paso atrás</translation>
    </message>
    <message>
        <source>One iteration back, exactly</source>
        <translation>Una iteración atrás, con exactitud</translation>
    </message>
    <message>
        <source>&amp;Next event</source>
        <translation>&amp;Evento siguiente</translation>
    </message>
    <message>
        <source>To the next change of topology; grows until there is one</source>
        <translation>Al siguiente cambio de topología; crece hasta que haya uno</translation>
    </message>
    <message>
        <source>&amp;Previous event</source>
        <translation>Evento &amp;anterior</translation>
    </message>
    <message>
        <source>To the previous change of topology</source>
        <translation>Al cambio de topología anterior</translation>
    </message>
    <message>
        <source>Back to the s&amp;tart</source>
        <translation>&amp;Volver al inicio</translation>
    </message>
    <message>
        <source>To the seed spheres</source>
        <translation>A las esferas de las semillas</translation>
    </message>
    <message>
        <source>To the &amp;last step</source>
        <translation>A&amp;l último paso</translation>
    </message>
    <message>
        <source>To the last iteration that was worked out</source>
        <translation>A la última iteración calculada</translation>
    </message>
    <message>
        <source>&amp;Correct</source>
        <translation>C&amp;orregir</translation>
    </message>
    <message>
        <source>&amp;Paint walls</source>
        <translation>&amp;Pintar barreras</translation>
    </message>
    <message>
        <source>Drag in a slice: the surface may not go where it is painted</source>
        <translation>Arrastrar en un corte: la superficie no puede ir donde está pintado</translation>
    </message>
    <message>
        <source>&amp;Erase walls</source>
        <translation>&amp;Borrar barreras</translation>
    </message>
    <message>
        <source>Drag in a slice: what the eraser touches is no wall any more</source>
        <translation>Arrastrar en un corte: lo que toca la goma deja de ser barrera</translation>
    </message>
    <message>
        <source>&amp;Larger brush</source>
        <translation>Pincel &amp;mayor</translation>
    </message>
    <message>
        <source>Radius of the brush a tenth larger</source>
        <translation>Radio del pincel una décima mayor</translation>
    </message>
    <message>
        <source>S&amp;maller brush</source>
        <translation>P&amp;incel menor</translation>
    </message>
    <message>
        <source>Radius of the brush a tenth smaller</source>
        <translation>Radio del pincel una décima menor</translation>
    </message>
    <message>
        <source>&amp;Wall at the crosshair</source>
        <translation>Barrera &amp;en la cruz</translation>
    </message>
    <message>
        <source>A wall as large as the brush where the crosshair is</source>
        <translation>Una barrera del tamaño del pincel donde está la cruz</translation>
    </message>
    <message>
        <source>E&amp;rase at the crosshair</source>
        <translation>Borrar en &amp;la cruz</translation>
    </message>
    <message>
        <source>No walls where the eraser would touch them at the crosshair</source>
        <translation>Sin barreras donde la goma las toca en la cruz</translation>
    </message>
    <message>
        <source>Go &amp;on from before the walls</source>
        <translation>&amp;Seguir desde antes de las barreras</translation>
    </message>
    <message>
        <source>Back to before the surface came to the new walls, and on from there</source>
        <translation>Volver a antes de que la superficie llegara a las barreras nuevas, y seguir desde allí</translation>
    </message>
    <message>
        <source>Remo&amp;ve all walls</source>
        <translation>&amp;Quitar todas las barreras</translation>
    </message>
    <message>
        <source>Nothing that was painted is a wall any more</source>
        <translation>Nada de lo pintado es ya barrera</translation>
    </message>
    <message>
        <source>Pin &amp;by brush</source>
        <translation>&amp;Fijar con el pincel</translation>
    </message>
    <message>
        <source>Drag over the surface, in a slice or in 3D: what the brush covers stays as it is from the shown iteration on</source>
        <translation>Arrastrar sobre la superficie, en un corte o en 3D: lo que cubre el pincel queda como está desde la iteración mostrada</translation>
    </message>
    <message>
        <source>Unp&amp;in by brush</source>
        <translation>Soltar &amp;con el pincel</translation>
    </message>
    <message>
        <source>Drag over the surface, in a slice or in 3D: pins that the brush touches hold no more</source>
        <translation>Arrastrar sobre la superficie, en un corte o en 3D: las fijaciones que toca el pincel ya no sujetan</translation>
    </message>
    <message>
        <source>Smoot&amp;h by brush</source>
        <translation>S&amp;uavizar con el pincel</translation>
    </message>
    <message>
        <source>Click on the surface, in a slice or in 3D: it is smoothed under the brush, as the next step</source>
        <translation>Hacer clic en la superficie, en un corte o en 3D: se suaviza bajo el pincel, como siguiente paso</translation>
    </message>
    <message>
        <source>Pull by &amp;dragging</source>
        <translation>Estirar &amp;arrastrando</translation>
    </message>
    <message>
        <source>Drag a point of the surface, in a slice or in 3D: it goes there, and what lies within the brush's radius less and less, as the next step</source>
        <translation>Arrastrar un punto de la superficie, en un corte o en 3D: va allí, y lo que está en el radio del pincel cada vez menos, como siguiente paso</translation>
    </message>
    <message>
        <source>Cut alon&amp;g a line</source>
        <translation>Cortar a lo largo &amp;de una línea</translation>
    </message>
    <message>
        <source>Draw a line across the surface in a slice: it is cut there at right angles to the slice, and closed on both sides, as the next step</source>
        <translation>Trazar una línea a través de la superficie en un corte: se corta allí perpendicularmente al corte y se cierra por ambos lados, como siguiente paso</translation>
    </message>
    <message>
        <source>Remove &amp;all pins</source>
        <translation>Quitar &amp;todas las fijaciones</translation>
    </message>
    <message>
        <source>Nothing of the surface is pinned any more</source>
        <translation>Nada de la superficie está ya fijado</translation>
    </message>
    <message>
        <source>Pi&amp;n here</source>
        <translation>Fi&amp;jar aquí</translation>
    </message>
    <message>
        <source>The surface around the crosshair stays as it is from the shown iteration on</source>
        <translation>La superficie alrededor de la cruz queda como está desde la iteración mostrada</translation>
    </message>
    <message>
        <source>&amp;Smooth here</source>
        <translation>Sua&amp;vizar aquí</translation>
    </message>
    <message>
        <source>Smooth the surface around its point nearest to the crosshair, as the next step</source>
        <translation>Suavizar la superficie alrededor de su punto más cercano a la cruz, como siguiente paso</translation>
    </message>
    <message>
        <source>P&amp;ull here</source>
        <translation>Esti&amp;rar aquí</translation>
    </message>
    <message>
        <source>Pull the point of the surface nearest to the crosshair there, as the next step</source>
        <translation>Llevar allí el punto de la superficie más cercano a la cruz, como siguiente paso</translation>
    </message>
    <message>
        <source>&amp;Cut here</source>
        <translation>C&amp;ortar aquí</translation>
    </message>
    <message>
        <source>Cut along the chosen plane through the crosshair, as the next step</source>
        <translation>Cortar por el plano elegido que pasa por la cruz, como siguiente paso</translation>
    </message>
    <message>
        <source>&amp;Objects</source>
        <translation>O&amp;bjetos</translation>
    </message>
    <message>
        <source>&amp;Add object</source>
        <translation>&amp;Añadir objeto</translation>
    </message>
    <message>
        <source>Another object in this volume; the surfaces before it are walls for it</source>
        <translation>Otro objeto en este volumen; las superficies anteriores son barreras para él</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplicar</translation>
    </message>
    <message>
        <source>Another object with the same seeds and parameters</source>
        <translation>Otro objeto con las mismas semillas y parámetros</translation>
    </message>
    <message>
        <source>D&amp;elete object</source>
        <translation>&amp;Eliminar objeto</translation>
    </message>
    <message>
        <source>Delete the active object with its seeds and surface</source>
        <translation>Eliminar el objeto activo con sus semillas y su superficie</translation>
    </message>
    <message>
        <source>&amp;Properties…</source>
        <translation>&amp;Propiedades…</translation>
    </message>
    <message>
        <source>Name, colour, label value and term of the active object</source>
        <translation>Nombre, color, valor de etiqueta y término del objeto activo</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>&amp;Subir</translation>
    </message>
    <message>
        <source>The active object earlier in the list: what two claim belongs to the first</source>
        <translation>El objeto activo antes en la lista: lo que dos reclaman pertenece al primero</translation>
    </message>
    <message>
        <source>Move do&amp;wn</source>
        <translation>&amp;Bajar</translation>
    </message>
    <message>
        <source>The active object later in the list</source>
        <translation>El objeto activo después en la lista: lo que dos reclaman pertenece al primero</translation>
    </message>
    <message>
        <source>&amp;Next object</source>
        <translation>&amp;Objeto siguiente</translation>
    </message>
    <message>
        <source>The next object of the list is active</source>
        <translation>El objeto siguiente de la lista pasa a ser el activo</translation>
    </message>
    <message>
        <source>P&amp;revious object</source>
        <translation>Objeto ante&amp;rior</translation>
    </message>
    <message>
        <source>The object before it in the list is active</source>
        <translation>El objeto anterior de la lista pasa a ser el activo</translation>
    </message>
    <message>
        <source>&amp;Visible</source>
        <translation>&amp;Visible</translation>
    </message>
    <message>
        <source>Draw the surface of the active object</source>
        <translation>Dibujar la superficie del objeto activo</translation>
    </message>
    <message>
        <source>&amp;Locked</source>
        <translation>B&amp;loqueado</translation>
    </message>
    <message>
        <source>Change nothing of the active object</source>
        <translation>No cambiar nada del objeto activo</translation>
    </message>
    <message>
        <source>&amp;Grow all</source>
        <translation>&amp;Hacer crecer todos</translation>
    </message>
    <message>
        <source>Grow all objects that are not done, in the order of the list</source>
        <translation>Hacer crecer todos los objetos no terminados, en el orden de la lista</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Medir</translation>
    </message>
    <message>
        <source>&amp;Measures</source>
        <translation>&amp;Medidas</translation>
    </message>
    <message>
        <source>Volume, area, diameters, intensities and distances of the objects, as a table</source>
        <translation>Volumen, área, diámetros, intensidades y distancias de los objetos, en una tabla</translation>
    </message>
    <message>
        <source>&amp;Ruler</source>
        <translation>&amp;Regla</translation>
    </message>
    <message>
        <source>Click two points in the slices or on the surface: their distance in mm</source>
        <translation>Hacer clic en dos puntos de los cortes o de la superficie: su distancia en mm</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>Á&amp;ngulo</translation>
    </message>
    <message>
        <source>Click three points, the second where the legs meet: the angle in degrees</source>
        <translation>Hacer clic en tres puntos, el segundo donde se unen los lados: el ángulo en grados</translation>
    </message>
    <message>
        <source>&amp;Centre line</source>
        <translation>Línea &amp;central</translation>
    </message>
    <message>
        <source>Click two places of an object: the line along its middle and the sections across it</source>
        <translation>Hacer clic en dos lugares de un objeto: la línea por su centro y las secciones</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>&amp;Guide</source>
        <translation>&amp;Guía</translation>
    </message>
    <message>
        <source>How to use the program</source>
        <translation>Cómo usar el programa</translation>
    </message>
    <message>
        <source>&amp;Keyboard and mouse</source>
        <translation>&amp;Teclado y ratón</translation>
    </message>
    <message>
        <source>All keys and mouse buttons</source>
        <translation>Todas las teclas y botones del ratón</translation>
    </message>
    <message>
        <source>&amp;About Handlebody</source>
        <translation>&amp;Acerca de Handlebody</translation>
    </message>
    <message>
        <source>Version, purpose, licences</source>
        <translation>Versión, propósito, licencias</translation>
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
        <translation>Distancia media de las superficies, ASSD (mm)</translation>
    </message>
    <message>
        <source>95 % Hausdorff distance (mm)</source>
        <translation>Distancia de Hausdorff del 95 % (mm)</translation>
    </message>
    <message>
        <source>Hausdorff distance (mm)</source>
        <translation>Distancia de Hausdorff (mm)</translation>
    </message>
    <message>
        <source>Volume (ml)</source>
        <translation>Volumen (ml)</translation>
    </message>
    <message>
        <source>Volume, difference (ml)</source>
        <translation>Volumen, diferencia (ml)</translation>
    </message>
    <message>
        <source>Area (cm²)</source>
        <translation>Área (cm²)</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Componentes</translation>
    </message>
    <message>
        <source>Tunnels</source>
        <translation>Túneles</translation>
    </message>
    <message>
        <source>Cavities</source>
        <translation>Cavidades</translation>
    </message>
    <message>
        <source> or </source>
        <translation> o </translation>
    </message>
    <message>
        <source>Mouse and keys in a slice</source>
        <translation>Ratón y teclas en un corte</translation>
    </message>
    <message>
        <source>Left click</source>
        <translation>Clic izquierdo</translation>
    </message>
    <message>
        <source>Crosshair</source>
        <translation>Cruz</translation>
    </message>
    <message>
        <source>Return; with Shift</source>
        <translation>Intro; con Mayús</translation>
    </message>
    <message>
        <source>Seed at the crosshair; click outside of the object</source>
        <translation>Semilla en la cruz; punto exterior</translation>
    </message>
    <message>
        <source>Left drag on a seed, on its rim</source>
        <translation>Arrastrar con izquierdo una semilla, su borde</translation>
    </message>
    <message>
        <source>Move it, change its radius</source>
        <translation>Moverla, cambiar su radio</translation>
    </message>
    <message>
        <source>Wheel; with Shift</source>
        <translation>Rueda; con Mayús</translation>
    </message>
    <message>
        <source>Next slice; five slices</source>
        <translation>Corte siguiente; cinco cortes</translation>
    </message>
    <message>
        <source>Right drag, Ctrl+wheel</source>
        <translation>Arrastrar con derecho, Ctrl+rueda</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Middle drag, Shift+left drag</source>
        <translation>Arrastrar con central, Mayús+izquierdo</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Desplazar</translation>
    </message>
    <message>
        <source>Arrows; with Shift</source>
        <translation>Flechas; con Mayús</translation>
    </message>
    <message>
        <source>Crosshair by one voxel; by five</source>
        <translation>Cruz un vóxel; cinco</translation>
    </message>
    <message>
        <source>Page Up, Page Down</source>
        <translation>Re Pág, Av Pág</translation>
    </message>
    <message>
        <source>Next, previous slice</source>
        <translation>Corte siguiente, anterior</translation>
    </message>
    <message>
        <source>B or E, then left drag; Ctrl+wheel</source>
        <translation>B o E, luego arrastrar; Ctrl+rueda</translation>
    </message>
    <message>
        <source>Paint or erase walls; radius of the brush</source>
        <translation>Pintar o borrar barreras; radio del pincel</translation>
    </message>
    <message>
        <source>R, A or C, then clicks</source>
        <translation>R, A o C, luego clics</translation>
    </message>
    <message>
        <source>Ruler, angle, centre line: place points; Return: at the crosshair</source>
        <translation>Regla, ángulo, línea central: poner puntos; Intro: en la cruz</translation>
    </message>
    <message>
        <source>Left drag on the end of a ruler or an angle</source>
        <translation>Arrastrar el extremo de una regla o un ángulo</translation>
    </message>
    <message>
        <source>Move it</source>
        <translation>Moverlo</translation>
    </message>
    <message>
        <source>L or Shift+L, then left drag</source>
        <translation>L o Mayús+L, luego arrastrar</translation>
    </message>
    <message>
        <source>Pin or unpin the surface under the brush</source>
        <translation>Fijar o soltar la superficie bajo el pincel</translation>
    </message>
    <message>
        <source>M, then left click</source>
        <translation>M, luego clic izquierdo</translation>
    </message>
    <message>
        <source>Smooth the surface under the brush</source>
        <translation>Suavizar la superficie bajo el pincel</translation>
    </message>
    <message>
        <source>U, then left drag from the outline</source>
        <translation>U, luego arrastrar desde el contorno</translation>
    </message>
    <message>
        <source>Pull the surface by that point</source>
        <translation>Estirar la superficie por ese punto</translation>
    </message>
    <message>
        <source>X, then left drag across the outline</source>
        <translation>X, luego arrastrar a través del contorno</translation>
    </message>
    <message>
        <source>Cut the surface along that line</source>
        <translation>Cortar la superficie a lo largo de esa línea</translation>
    </message>
    <message>
        <source>W, then left drag</source>
        <translation>W, luego arrastrar</translation>
    </message>
    <message>
        <source>Window (sideways) and level (up and down)</source>
        <translation>Ventana (a los lados) y nivel (arriba y abajo)</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doble clic</translation>
    </message>
    <message>
        <source>This view alone, or all four</source>
        <translation>Solo esta vista, o las cuatro</translation>
    </message>
    <message>
        <source>Mouse in the 3D view</source>
        <translation>Ratón en la vista 3D</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>Arrastrar con izquierdo</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Girar</translation>
    </message>
    <message>
        <source>L, Shift+L, M or U, then left on the surface</source>
        <translation>L, Mayús+L, M o U, luego izquierdo en la superficie</translation>
    </message>
    <message>
        <source>Pin, unpin, smooth, pull; beside it: rotate</source>
        <translation>Fijar, soltar, suavizar, estirar; al lado: girar</translation>
    </message>
    <message>
        <source>R, A or C, then clicks on the surface</source>
        <translation>R, A o C, luego clics en la superficie</translation>
    </message>
    <message>
        <source>Ruler, angle, centre line: place points</source>
        <translation>Regla, ángulo, línea central: poner puntos</translation>
    </message>
    <message>
        <source>Right drag, wheel</source>
        <translation>Arrastrar con derecho, rueda</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Mensajes</translation>
    </message>
    <message>
        <source>Close the message over the views; else give up a stroke or a point, put brush and ruler away, leave window and level</source>
        <translation>Cerrar el mensaje sobre las vistas; si no, abandonar un trazo o un punto, dejar pincel y regla, salir de ventana y nivel</translation>
    </message>
    <message>
        <source>window</source>
        <translation>ventana</translation>
    </message>
    <message>
        <source>3D view, mesh files, pictures</source>
        <translation>vista 3D, archivos de mallas, imágenes</translation>
    </message>
    <message>
        <source>reading and writing volumes</source>
        <translation>lectura y escritura de volúmenes</translation>
    </message>
    <message>
        <source>linear algebra</source>
        <translation>álgebra lineal</translation>
    </message>
    <message>
        <source>SHA-256 of volumes</source>
        <translation>SHA-256 de los volúmenes</translation>
    </message>
    <message>
        <source>compressed files</source>
        <translation>archivos comprimidos</translation>
    </message>
    <message>
        <source>sessions and reports</source>
        <translation>sesiones e informes</translation>
    </message>
    <message>
        <source>command line</source>
        <translation>línea de órdenes</translation>
    </message>
    <message>
        <source>Keyboard and mouse</source>
        <translation>Teclado y ratón</translation>
    </message>
    <message>
        <source>Grows a certified surface from a point in a medical volume; the surface may change its topology on the way.</source>
        <translation>Hace crecer una superficie certificada desde un punto de un volumen médico; su topología puede cambiar por el camino.</translation>
    </message>
    <message>
        <source>Apache License 2.0. The method is that of the paper “A Combinatorial Method for Topology Adaptations in 3D Deformable Models”.</source>
        <translation>Licencia Apache 2.0. El método es el del artículo «A Combinatorial Method for Topology Adaptations in 3D Deformable Models».</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>Bibliotecas</translation>
    </message>
    <message>
        <source>Qt is linked dynamically and can be replaced by another version of it.</source>
        <translation>Qt está enlazado dinámicamente y puede reemplazarse por otra versión.</translation>
    </message>
    <message>
        <source>For research use only. Handlebody is not a medical device; do not use it for diagnosis or treatment.</source>
        <translation>Solo para investigación. Handlebody no es un producto sanitario; no lo use para diagnóstico ni tratamiento.</translation>
    </message>
    <message>
        <source>they meet</source>
        <translation>se tocan</translation>
    </message>
    <message>
        <source>%1, one within the other</source>
        <translation>%1, uno dentro del otro</translation>
    </message>
    <message>
        <source>  from %1: mean %2, least %3, 95 % up to %4, largest %5</source>
        <translation>  desde %1: media %2, mínimo %3, 95 % hasta %4, máximo %5</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objeto</translation>
    </message>
    <message>
        <source>Volume
(ml)</source>
        <translation>Volumen
(ml)</translation>
    </message>
    <message>
        <source>Area
(cm²)</source>
        <translation>Área
(cm²)</translation>
    </message>
    <message>
        <source>Largest
Ø (mm)</source>
        <translation>Ø mayor
(mm)</translation>
    </message>
    <message>
        <source>Intensity
mean ± SD</source>
        <translation>Intensidad
media ± DE</translation>
    </message>
    <message>
        <source>Nearest object
(mm)</source>
        <translation>Objeto más
cercano (mm)</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Along its axes: %1 mm</source>
        <translation>A lo largo de sus ejes: %1 mm</translation>
    </message>
    <message>
        <source>Along x, y, z: %1 mm</source>
        <translation>A lo largo de x, y, z: %1 mm</translation>
    </message>
    <message>
        <source>Largest Ø from %1 to %2</source>
        <translation>Ø mayor de %1 a %2</translation>
    </message>
    <message>
        <source>Centroid: %1 LPS</source>
        <translation>Centroide: %1 LPS</translation>
    </message>
    <message>
        <source>Intensity %1 to %2, %3 voxels</source>
        <translation>Intensidad de %1 a %2, %3 vóxeles</translation>
    </message>
    <message>
        <source>Components %1, cavities %2, tunnels %3</source>
        <translation>Componentes %1, cavidades %2, túneles %3</translation>
    </message>
    <message>
        <source>Distance to “%1”: %2</source>
        <translation>Distancia a «%1»: %2</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>Grosor de pared</translation>
    </message>
    <message>
        <source>Length %1, in “%2”</source>
        <translation>Longitud %1, en «%2»</translation>
    </message>
    <message>
        <source>Least section: %1</source>
        <translation>Sección menor: %1</translation>
    </message>
    <message>
        <source>Largest: %1</source>
        <translation>Mayor: %1</translation>
    </message>
    <message>
        <source>at %1: no section</source>
        <translation>en %1: sin sección</translation>
    </message>
    <message>
        <source>at %1: %2 mm², Ø %3</source>
        <translation>en %1: %2 mm², Ø %3</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Abrir &amp;reciente</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>P&amp;aneles</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Suavizado</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Standard deviation of the Gaussian that smooths the image ahead. More for more speckle; 0 for none.</source>
        <translation>Desviación típica de la gaussiana que suaviza antes la imagen. Más cuanto más moteado; 0 para ninguno.</translation>
    </message>
    <message>
        <source>Edge length</source>
        <translation>Longitud de arista</translation>
    </message>
    <message>
        <source>Length that the edges of the mesh are kept near. Shorter shows finer detail and takes longer.</source>
        <translation>Longitud cerca de la cual se mantienen las aristas. Más corta muestra más detalle y tarda más.</translation>
    </message>
    <message>
        <source>Balloon</source>
        <translation>Globo</translation>
    </message>
    <message>
        <source>Weight of the force that drives the surface outward. Less keeps it from leaking.</source>
        <translation>Peso de la fuerza que empuja la superficie hacia fuera. Menos evita que se fugue.</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Curvatura</translation>
    </message>
    <message>
        <source>Weight of smoothness. More closes narrow leaks and rounds the surface off.</source>
        <translation>Peso de la suavidad. Más cierra fugas estrechas y redondea la superficie.</translation>
    </message>
    <message>
        <source>Iteration limit</source>
        <translation>Límite de iteraciones</translation>
    </message>
    <message>
        <source>The growth stops after so many iterations, finished or not.</source>
        <translation>El crecimiento se detiene tras tantas iteraciones, acabado o no.</translation>
    </message>
    <message>
        <source>The file cannot be read.</source>
        <translation>No se puede leer el archivo.</translation>
    </message>
    <message>
        <source>The file cannot be written.</source>
        <translation>No se puede escribir el archivo.</translation>
    </message>
    <message>
        <source>Open a volume (NIfTI, NRRD, MetaImage, GIPL, TIFF, DICOM) or a session</source>
        <translation>Abrir un volumen (NIfTI, NRRD, MetaImage, GIPL, TIFF, DICOM) o una sesión</translation>
    </message>
    <message>
        <source>Open o&amp;bjects…</source>
        <translation>Abrir o&amp;bjetos…</translation>
    </message>
    <message>
        <source>Take surfaces of a mesh (STL, VTP, PLY, OBJ, 3MF) or a label map (DICOM, 3D Slicer, NIfTI, NRRD, MetaImage) as objects: as they are, or to grow from</source>
        <translation>Tomar como objetos las superficies de una malla (STL, VTP, PLY, OBJ, 3MF) o de un mapa de etiquetas (DICOM, 3D Slicer, NIfTI, NRRD, MetaImage): tal como son, o para crecer desde ellas</translation>
    </message>
    <message>
        <source>&amp;Time</source>
        <translation>&amp;Tiempo</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Reproducir</translation>
    </message>
    <message>
        <source>Play the frames of the volume, or stop</source>
        <translation>Reproducir los fotogramas del volumen, o detener</translation>
    </message>
    <message>
        <source>P&amp;revious frame</source>
        <translation>Fotograma &amp;anterior</translation>
    </message>
    <message>
        <source>The frame before the shown one</source>
        <translation>El fotograma anterior al mostrado</translation>
    </message>
    <message>
        <source>&amp;Next frame</source>
        <translation>Fotograma &amp;siguiente</translation>
    </message>
    <message>
        <source>The frame after the shown one</source>
        <translation>El fotograma siguiente al mostrado</translation>
    </message>
    <message>
        <source>&amp;Back to where it is grown</source>
        <translation>&amp;Volver a donde crece</translation>
    </message>
    <message>
        <source>The frame in which the surface is grown</source>
        <translation>El fotograma en que crece la superficie</translation>
    </message>
    <message>
        <source>&amp;Grow in this frame</source>
        <translation>&amp;Crecer en este fotograma</translation>
    </message>
    <message>
        <source>Grow in the shown frame with the same clicks; what was grown in the other one is gone</source>
        <translation>Hacer crecer en el fotograma mostrado con los mismos puntos; lo que creció en el otro desaparece</translation>
    </message>
    <message>
        <source>&amp;Over time</source>
        <translation>En el &amp;tiempo</translation>
    </message>
    <message>
        <source>Carry the surface from its frame through the others, both ways, in the background</source>
        <translation>Propagar la superficie desde su fotograma a los demás, en ambos sentidos, en segundo plano</translation>
    </message>
    <message>
        <source>&amp;Correct this frame</source>
        <translation>C&amp;orregir este fotograma</translation>
    </message>
    <message>
        <source>Change the surface of the shown frame with clicks, walls and edits, from that of the frame beside it on</source>
        <translation>Cambiar la superficie del fotograma mostrado con puntos, barreras y ediciones, a partir de la del fotograma contiguo</translation>
    </message>
    <message>
        <source>Carry on &amp;from here</source>
        <translation>Propagar desde a&amp;quí</translation>
    </message>
    <message>
        <source>The correction counts: the frames beyond this one are carried again from it</source>
        <translation>La corrección vale: los fotogramas que siguen a este se propagan de nuevo desde ella</translation>
    </message>
    <message>
        <source>&amp;Drop the correction</source>
        <translation>&amp;Descartar la corrección</translation>
    </message>
    <message>
        <source>Back to the frame that is grown; what was carried stays as it was</source>
        <translation>Volver al fotograma en que crece; lo propagado queda como estaba</translation>
    </message>
    <message>
        <source>&amp;Volume over time</source>
        <translation>Vo&amp;lumen en el tiempo</translation>
    </message>
    <message>
        <source>The volume of every frame, ejection fraction, and what went wrong in which frame</source>
        <translation>El volumen de cada fotograma, la fracción de eyección y qué falló en cada uno</translation>
    </message>
    <message>
        <source>Export &amp;meshes of all frames…</source>
        <translation>Exportar &amp;mallas de todos los fotogramas…</translation>
    </message>
    <message>
        <source>Write the surface of every frame, numbered, with a list for ParaView (.pvd) beside .vtp</source>
        <translation>Escribir la superficie de cada fotograma, numerada, con una lista para ParaView (.pvd) junto a .vtp</translation>
    </message>
    <message>
        <source>Export 4D &amp;label map…</source>
        <translation>Exportar mapa de &amp;etiquetas 4D…</translation>
    </message>
    <message>
        <source>Write the surfaces of all frames as one label map with four dimensions</source>
        <translation>Escribir las superficies de todos los fotogramas como un mapa de etiquetas de cuatro dimensiones</translation>
    </message>
    <message>
        <source>&amp;Sensitivity</source>
        <translation>&amp;Sensibilidad</translation>
    </message>
    <message>
        <source>Grow it again with clicks, smoothing and noise a little different: how much do volume and surface change?</source>
        <translation>Hacer crecer de nuevo con puntos, suavizado y ruido algo distintos: ¿cuánto cambian el volumen y la superficie?</translation>
    </message>
    <message>
        <source>Export a&amp;nonymous session…</source>
        <translation>Exportar sesión a&amp;nónima…</translation>
    </message>
    <message>
        <source>Write a session that names neither the patient nor a file: it asks for its volume when it is opened</source>
        <translation>Escribe una sesión que no nombra ni al paciente ni ningún archivo: al abrirla pide su volumen</translation>
    </message>
    <message>
        <source>the first point lies outside of the object</source>
        <translation>el primer punto está fuera del objeto</translation>
    </message>
    <message>
        <source>the second point lies outside of the object</source>
        <translation>el segundo punto está fuera del objeto</translation>
    </message>
    <message>
        <source>the two points lie in the same place of the object</source>
        <translation>los dos puntos están en el mismo lugar del objeto</translation>
    </message>
    <message>
        <source>the way between them is too long and thin to be searched</source>
        <translation>el camino entre ellos es demasiado largo y delgado para explorarlo</translation>
    </message>
    <message>
        <source>there is no way from one to the other inside of the object</source>
        <translation>no hay camino de uno a otro dentro del objeto</translation>
    </message>
    <message>
        <source>3MF files</source>
        <translation>archivos 3MF</translation>
    </message>
    <message>
        <source>the outer surface</source>
        <translation>la superficie exterior</translation>
    </message>
    <message>
        <source>the cavities</source>
        <translation>las cavidades</translation>
    </message>
    <message>
        <source>writing DICOM files</source>
        <translation>escritura de archivos DICOM</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::CentreLinePage</name>
    <message>
        <source>The centre line</source>
        <translation>La línea central</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Guardar como CSV…</translation>
    </message>
    <message>
        <source>Save as CSV</source>
        <translation>Guardar como CSV</translation>
    </message>
    <message>
        <source>The same table as “handlebody-cli measure --sections” writes</source>
        <translation>La misma tabla que escribe «handlebody-cli measure --sections»</translation>
    </message>
    <message>
        <source>Save the sections</source>
        <translation>Guardar las secciones</translation>
    </message>
    <message>
        <source>Between two places in an object, along its middle.</source>
        <translation>Entre dos lugares de un objeto, por su centro.</translation>
    </message>
    <message>
        <source>Click in the object or on its surface where the line begins, or press Return for the crosshair.</source>
        <translation>Haga clic en el objeto o en su superficie donde empieza la línea, o pulse Intro para la cruz.</translation>
    </message>
    <message>
        <source>Click where it ends. Escape takes the beginning back.</source>
        <translation>Haga clic donde termina. Escape retira el comienzo.</translation>
    </message>
    <message>
        <source>Searching for the middle of the object…</source>
        <translation>Buscando el centro del objeto…</translation>
    </message>
    <message>
        <source>Pointed at: %1</source>
        <translation>Señalado: %1</translation>
    </message>
    <message>
        <source>It was made in an earlier surface.</source>
        <translation>Se hizo en una superficie anterior.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Search no longer</source>
        <translation>No buscar más</translation>
    </message>
    <message>
        <source>Draw the line no more</source>
        <translation>No dibujar más la línea</translation>
    </message>
    <message>
        <source>Save as JSON…</source>
        <translation>Guardar como JSON…</translation>
    </message>
    <message>
        <source>Save as JSON</source>
        <translation>Guardar como JSON</translation>
    </message>
    <message>
        <source>The same as “handlebody-cli measure --json” writes of the line</source>
        <translation>Lo mismo que «handlebody-cli measure --json» escribe de la línea</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ComparePage</name>
    <message>
        <source>Figure</source>
        <translation>Cifra</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objeto</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referencia</translation>
    </message>
    <message>
        <source>The object beside the reference</source>
        <translation>El objeto junto a la referencia</translation>
    </message>
    <message>
        <source>Save the comparison</source>
        <translation>Guardar la comparación</translation>
    </message>
    <message>
        <source>Choose reference…</source>
        <translation>Elegir referencia…</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Compare the shown surface with the reference</source>
        <translation>Comparar la superficie mostrada con la referencia</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Guardar como CSV…</translation>
    </message>
    <message>
        <source>The same table as “handlebody-cli compare --csv” writes</source>
        <translation>La misma tabla que escribe «handlebody-cli compare --csv»</translation>
    </message>
    <message>
        <source>Save as JSON…</source>
        <translation>Guardar como JSON…</translation>
    </message>
    <message>
        <source>The same as “handlebody-cli compare --report” writes</source>
        <translation>Lo mismo que escribe «handlebody-cli compare --report»</translation>
    </message>
    <message>
        <source>The reference</source>
        <translation>La referencia</translation>
    </message>
    <message>
        <source>State of the comparison</source>
        <translation>Estado de la comparación</translation>
    </message>
    <message>
        <source>all but 0</source>
        <translation>todos menos 0</translation>
    </message>
    <message>
        <source>Which voxels of a label map are the reference</source>
        <translation>Qué vóxeles de un mapa de etiquetas son la referencia</translation>
    </message>
    <message>
        <source>Distances in colour on the surface</source>
        <translation>Distancias en color sobre la superficie</translation>
    </message>
    <message>
        <source>Blue inside of the reference, red outside of it</source>
        <translation>Azul dentro de la referencia, rojo fuera</translation>
    </message>
    <message>
        <source>The objects are compared</source>
        <translation>Se comparan los objetos</translation>
    </message>
    <message>
        <source>Choose the reference</source>
        <translation>Elegir la referencia</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>No reference is chosen.</source>
        <translation>No hay referencia elegida.</translation>
    </message>
    <message>
        <source>There is no surface to compare yet: grow one first.</source>
        <translation>Aún no hay superficie que comparar: haga crecer una primero.</translation>
    </message>
    <message>
        <source>Comparing…</source>
        <translation>Comparando…</translation>
    </message>
    <message>
        <source>These are figures of an earlier surface, or of another object.</source>
        <translation>Estas cifras son de una superficie anterior o de otro objeto.</translation>
    </message>
    <message>
        <source>A mesh, a label map or another object to compare the active object with</source>
        <translation>Una malla, un mapa de etiquetas u otro objeto con que comparar el objeto activo</translation>
    </message>
    <message>
        <source>Save distances…</source>
        <translation>Guardar distancias…</translation>
    </message>
    <message>
        <source>The surface with its distance from the reference at every vertex, as “handlebody-cli compare -o” writes it</source>
        <translation>La superficie con su distancia a la referencia en cada vértice, como la escribe «handlebody-cli compare -o»</translation>
    </message>
    <message>
        <source>Why no labels are listed</source>
        <translation>Por qué no se listan etiquetas</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Etiqueta</translation>
    </message>
    <message>
        <source>Label of the reference</source>
        <translation>Etiqueta de la referencia</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>De un archivo…</translation>
    </message>
    <message>
        <source>Save the distances</source>
        <translation>Guardar las distancias</translation>
    </message>
    <message>
        <source>Meshes and label maps (*.stl *.vtp *.ply *.obj *.3mf *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.dcm);;All files (*)</source>
        <translation>Mallas y mapas de etiquetas (*.stl *.vtp *.ply *.obj *.3mf *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.dcm);;Todos los archivos (*)</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::Document</name>
    <message>
        <source>“%1” is locked: unlock it to change it.</source>
        <translation>«%1» está bloqueado: desbloquéelo para cambiarlo.</translation>
    </message>
    <message>
        <source>Add click outside</source>
        <translation>Añadir punto exterior</translation>
    </message>
    <message>
        <source>Add seed</source>
        <translation>Añadir semilla</translation>
    </message>
    <message>
        <source>Delete click outside</source>
        <translation>Eliminar punto exterior</translation>
    </message>
    <message>
        <source>Delete seed</source>
        <translation>Eliminar semilla</translation>
    </message>
    <message>
        <source>Move click outside</source>
        <translation>Mover punto exterior</translation>
    </message>
    <message>
        <source>Move seed</source>
        <translation>Mover semilla</translation>
    </message>
    <message>
        <source>Change radius of click outside</source>
        <translation>Cambiar radio del punto exterior</translation>
    </message>
    <message>
        <source>Change seed radius</source>
        <translation>Cambiar radio de la semilla</translation>
    </message>
    <message>
        <source>Smaller object</source>
        <translation>Objeto menor</translation>
    </message>
    <message>
        <source>Larger object</source>
        <translation>Objeto mayor</translation>
    </message>
    <message>
        <source>The wall would lie outside of the volume: it is not kept.</source>
        <translation>La barrera quedaría fuera del volumen: no se conserva.</translation>
    </message>
    <message>
        <source>The wall would lie over the seed at %1 mm: it is not kept.</source>
        <translation>La barrera quedaría sobre la semilla en %1 mm: no se conserva.</translation>
    </message>
    <message>
        <source>Paint wall</source>
        <translation>Pintar barrera</translation>
    </message>
    <message>
        <source>Erase wall</source>
        <translation>Borrar barrera</translation>
    </message>
    <message>
        <source>The surface has not come to rest yet: nothing is pinned.</source>
        <translation>La superficie aún no ha llegado al reposo: no se fija nada.</translation>
    </message>
    <message>
        <source>Pin here</source>
        <translation>Fijar aquí</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Fijar</translation>
    </message>
    <message>
        <source>This part of the surface is pinned already.</source>
        <translation>Esta parte de la superficie ya está fijada.</translation>
    </message>
    <message>
        <source>No vertex of the surface lies within %1 mm of %2 mm: nothing is pinned.</source>
        <translation>Ningún vértice de la superficie a menos de %1 mm de %2 mm: no se fija nada.</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>Soltar</translation>
    </message>
    <message>
        <source>Keep apart</source>
        <translation>Mantener separado</translation>
    </message>
    <message>
        <source>Keep as it is</source>
        <translation>Dejar como está</translation>
    </message>
    <message>
        <source>Wall here</source>
        <translation>Barrera aquí</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>Dejar que ocurra</translation>
    </message>
    <message>
        <source>Remove component</source>
        <translation>Quitar componente</translation>
    </message>
    <message>
        <source>Keep only one component</source>
        <translation>Conservar un solo componente</translation>
    </message>
    <message>
        <source>Fill cavity</source>
        <translation>Rellenar cavidad</translation>
    </message>
    <message>
        <source>Smooth here</source>
        <translation>Suavizar aquí</translation>
    </message>
    <message>
        <source>Pull here</source>
        <translation>Estirar aquí</translation>
    </message>
    <message>
        <source>Cut here</source>
        <translation>Cortar aquí</translation>
    </message>
    <message>
        <source>Cut handle</source>
        <translation>Cortar asa</translation>
    </message>
    <message>
        <source>Fill tunnel</source>
        <translation>Rellenar túnel</translation>
    </message>
    <message>
        <source>Close tunnel</source>
        <translation>Cerrar túnel</translation>
    </message>
    <message>
        <source>Leave out an edit</source>
        <translation>Omitir una edición</translation>
    </message>
    <message>
        <source>Object %1</source>
        <translation>Objeto %1</translation>
    </message>
    <message>
        <source>Add object</source>
        <translation>Añadir objeto</translation>
    </message>
    <message>
        <source>Duplicate object</source>
        <translation>Duplicar objeto</translation>
    </message>
    <message>
        <source>“%1” is locked: unlock it first.</source>
        <translation>«%1» está bloqueado: desbloquéelo primero.</translation>
    </message>
    <message>
        <source>Delete object</source>
        <translation>Eliminar objeto</translation>
    </message>
    <message>
        <source>Move object in the list</source>
        <translation>Mover objeto en la lista</translation>
    </message>
    <message>
        <source>Another object is called “%1”.</source>
        <translation>Otro objeto se llama «%1».</translation>
    </message>
    <message>
        <source>“%1” has the label value %2.</source>
        <translation>«%1» tiene el valor de etiqueta %2.</translation>
    </message>
    <message>
        <source>Show object</source>
        <translation>Mostrar objeto</translation>
    </message>
    <message>
        <source>Hide object</source>
        <translation>Ocultar objeto</translation>
    </message>
    <message>
        <source>Lock object</source>
        <translation>Bloquear objeto</translation>
    </message>
    <message>
        <source>Unlock object</source>
        <translation>Desbloquear objeto</translation>
    </message>
    <message>
        <source>“%1” meets “%2”, and nothing was written: grow it anew, so that it keeps clear.</source>
        <translation>«%1» toca «%2», y no se escribió nada: hágalo crecer de nuevo para que se mantenga apartado.</translation>
    </message>
    <message>
        <source>There is no surface to export yet: grow one first.</source>
        <translation>Aún no hay superficie que exportar: haga crecer una primero.</translation>
    </message>
    <message>
        <source>Nothing is left of the surface at this iteration: step back to one that has some.</source>
        <translation>En esta iteración no queda nada de la superficie: vuelva a una en la que quede algo.</translation>
    </message>
    <message>
        <source>There is no surface to report on yet: grow one first.</source>
        <translation>Aún no hay superficie de la que informar: haga crecer una primero.</translation>
    </message>
    <message>
        <source>There is nothing to save yet: open a volume first.</source>
        <translation>Aún no hay nada que guardar: abra antes un volumen.</translation>
    </message>
    <message>
        <source>A session needs a seed: place one inside the object first.</source>
        <translation>Una sesión necesita una semilla: ponga antes una dentro del objeto.</translation>
    </message>
    <message>
        <source>There is no seed yet: place one inside the object first.</source>
        <translation>Aún no hay semilla: ponga antes una dentro del objeto.</translation>
    </message>
    <message>
        <source>Hold it</source>
        <translation>Retener</translation>
    </message>
    <message>
        <source>The volume has one time point only.</source>
        <translation>El volumen tiene un solo instante.</translation>
    </message>
    <message>
        <source>Frame %1 is being corrected: end that first.</source>
        <translation>Se está corrigiendo el fotograma %1: termine eso antes.</translation>
    </message>
    <message>
        <source>In this frame the surface is grown: change it there as ever.</source>
        <translation>En este fotograma crece la superficie: cámbiela allí como siempre.</translation>
    </message>
    <message>
        <source>The surface is being carried: wait until that is done, or cancel it.</source>
        <translation>La superficie se está propagando: espere a que acabe, o cancele.</translation>
    </message>
    <message>
        <source>The surface has not been carried to this frame yet.</source>
        <translation>La superficie aún no se ha propagado a este fotograma.</translation>
    </message>
    <message>
        <source>The correction has no surface at rest yet: let it grow, or pause it.</source>
        <translation>La corrección aún no tiene una superficie en reposo: déjela crecer, o páusela.</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Barreras</translation>
    </message>
    <message>
        <source>Wall disc</source>
        <translation>Disco de barrera</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>Fijaciones</translation>
    </message>
    <message>
        <source>Veto</source>
        <translation>Veto</translation>
    </message>
    <message>
        <source>Edit by hand</source>
        <translation>Edición manual</translation>
    </message>
    <message>
        <source>Limits of the topology</source>
        <translation>Límites de la topología</translation>
    </message>
    <message>
        <source>Decided: let it happen</source>
        <translation>Decidido: dejar que ocurra</translation>
    </message>
    <message>
        <source>Decided: hold it</source>
        <translation>Decidido: retener</translation>
    </message>
    <message>
        <source>Clicks</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>A frame is being corrected: end that first.</source>
        <translation>Se está corrigiendo un fotograma: termine eso antes.</translation>
    </message>
    <message>
        <source>Open object</source>
        <translation>Abrir objeto</translation>
    </message>
    <message>
        <source>Open objects</source>
        <translation>Abrir objetos</translation>
    </message>
    <message>
        <source>Frame %1 is shown, and the surface is grown in frame %2: go there to change it.</source>
        <translation>Se muestra el fotograma %1 y la superficie crece en el fotograma %2: vaya allí para cambiarla.</translation>
    </message>
    <message>
        <source>Grow in frame %1</source>
        <translation>Crecer en el fotograma %1</translation>
    </message>
    <message>
        <source>Several objects are not carried over time: open the volume with one of them.</source>
        <translation>Varios objetos no se propagan en el tiempo: abra el volumen con uno solo.</translation>
    </message>
    <message>
        <source>The surface still grows: wait until it is at rest.</source>
        <translation>La superficie aún crece: espere a que repose.</translation>
    </message>
    <message>
        <source>There is no surface yet: grow one in a frame first.</source>
        <translation>Aún no hay superficie: haga crecer antes una en un fotograma.</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>En el tiempo</translation>
    </message>
    <message>
        <source>There are no surfaces over time of what is shown: carry it through the frames first.</source>
        <translation>No hay superficies en el tiempo de lo que se muestra: propáguela antes por los fotogramas.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>There is no surface yet: grow one first.</source>
        <translation>Aún no hay superficie: haga crecer una primero.</translation>
    </message>
    <message>
        <source>It is told of the frame that the surface is grown in: go there first.</source>
        <translation>Se calcula en el fotograma en que crece la superficie: vaya antes allí.</translation>
    </message>
    <message>
        <source>It is told of a surface that has come to rest: let it grow to its end first.</source>
        <translation>Se calcula de una superficie en reposo: déjela crecer antes hasta el final.</translation>
    </message>
    <message>
        <source>polished: %1 bad places, now %2; least angle %3°, was %4°.</source>
        <translation>pulida: %1 lugares malos, ahora %2; ángulo mínimo %3°, antes %4°.</translation>
    </message>
    <message>
        <source>“%1” %2</source>
        <translation>«%1» %2</translation>
    </message>
    <message>
        <source>A surface that comes from a file is not carried over time: grow one from a click.</source>
        <translation>Una superficie que viene de un archivo no se propaga en el tiempo: haga crecer una a partir de un clic.</translation>
    </message>
    <message>
        <source>The name is empty.</source>
        <translation>El nombre está vacío.</translation>
    </message>
    <message>
        <source>The name “%1” is not UTF-8.</source>
        <translation>El nombre «%1» no está en UTF-8.</translation>
    </message>
    <message>
        <source>The name “%1” has more than %2 characters.</source>
        <translation>El nombre «%1» tiene más de %2 caracteres.</translation>
    </message>
    <message>
        <source>The name “%1” holds a control character.</source>
        <translation>El nombre «%1» contiene un carácter de control.</translation>
    </message>
    <message>
        <source>The name “%1” holds %2, which separates in some of the formats.</source>
        <translation>El nombre «%1» contiene %2, que es un separador en algunos formatos.</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objeto</translation>
    </message>
    <message>
        <source>%1 cannot be written: it would be a part of the volume that is open. Choose another folder or name.</source>
        <translation>No se puede escribir %1: sería parte del volumen abierto. Elija otra carpeta u otro nombre.</translation>
    </message>
    <message>
        <source>A session keeps work over time of one object only: save this one, then open the volume anew to have several objects.</source>
        <translation>Una sesión conserva el trabajo en el tiempo de un solo objeto: guarde esta y abra después el volumen de nuevo para tener varios objetos.</translation>
    </message>
    <message>
        <source>“%1” still grows: wait until it is at rest, or pause it.</source>
        <translation>«%1» aún crece: espere a que esté en reposo o páuselo.</translation>
    </message>
    <message>
        <source>%1 cannot be written: the open work is read from it. Choose another folder or name.</source>
        <translation>No se puede escribir %1: el trabajo abierto se lee de ahí. Elija otra carpeta u otro nombre.</translation>
    </message>
    <message>
        <source>Work over time is left out while there are several objects: delete all but one to keep it.</source>
        <translation>El trabajo en el tiempo se omite mientras haya varios objetos: elimine todos menos uno para conservarlo.</translation>
    </message>
    <message>
        <source>“%1” is locked: unlock it to grow in another frame.</source>
        <translation>«%1» está bloqueado: desbloquéelo para crecer en otro fotograma.</translation>
    </message>
    <message>
        <source>Nothing is kept for the case that the program ends unexpectedly: save the session. %1</source>
        <translation>No se conserva nada por si el programa termina de forma inesperada: guarde la sesión. %1</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Of the frames %1–%2 the surface is in these only: %3. Carry it through all of them first.</source>
        <translation>De los fotogramas %1–%2, solo estos tienen la superficie: %3. Propáguela primero a todos.</translation>
    </message>
    <message>
        <source>Frames %1: %2</source>
        <translation>Fotogramas %1: %2</translation>
    </message>
    <message>
        <source>The surface is still grown in frame %1: frame %2 was not shown.</source>
        <translation>La superficie sigue creciendo en el fotograma %1: el fotograma %2 no se mostró.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::EventInspector</name>
    <message>
        <source>Stage 1 of 4: the triangles that run into each other.</source>
        <translation>Etapa 1 de 4: los triángulos que chocan.</translation>
    </message>
    <message>
        <source>Stage 2 of 4: the mesh without them, and the polygons that bound the openings.</source>
        <translation>Etapa 2 de 4: la malla sin ellos y los polígonos que bordean las aberturas.</translation>
    </message>
    <message>
        <source>Stage 3 of 4: the handle, or the caps, that close the openings.</source>
        <translation>Etapa 3 de 4: el asa, o las tapas, que cierran las aberturas.</translation>
    </message>
    <message>
        <source>Stage 4 of 4: the mesh with the handle in place.</source>
        <translation>Etapa 4 de 4: la malla con el asa en su sitio.</translation>
    </message>
    <message>
        <source>Before stage 2: the edges around them are halved, or the openings would not be bounded by simple polygons.</source>
        <translation>Antes de la etapa 2: las aristas a su alrededor se dividen por la mitad; si no, las aberturas no estarían bordeadas por polígonos simples.</translation>
    </message>
    <message>
        <source>Handle inserted</source>
        <translation>Asa insertada</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>División</translation>
    </message>
    <message>
        <source>Enclosed part cut off</source>
        <translation>Parte encerrada cortada</translation>
    </message>
    <message>
        <source>Tunnel closed</source>
        <translation>Túnel cerrado</translation>
    </message>
    <message>
        <source>Component deleted</source>
        <translation>Componente eliminado</translation>
    </message>
    <message>
        <source>Handle cut</source>
        <translation>Asa cortada</translation>
    </message>
    <message>
        <source>Component removed</source>
        <translation>Componente quitado</translation>
    </message>
    <message>
        <source>Cavity filled</source>
        <translation>Cavidad rellenada</translation>
    </message>
    <message>
        <source>Fold smoothed</source>
        <translation>Pliegue suavizado</translation>
    </message>
    <message>
        <source>Cut by a plane</source>
        <translation>Cortado por un plano</translation>
    </message>
    <message>
        <source>Smoothed by hand</source>
        <translation>Suavizado a mano</translation>
    </message>
    <message>
        <source>Pulled</source>
        <translation>Estirado</translation>
    </message>
    <message>
        <source>Rolled back</source>
        <translation>Revertido</translation>
    </message>
    <message>
        <source>Held: %1</source>
        <translation>Retenido: %1</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Evento</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Etapa</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>No</translation>
    </message>
    <message>
        <source>Collide</source>
        <translation>Choque</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>Asa</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Show the whole surface</source>
        <translation>Mostrar toda la superficie</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>Refinar</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>Event: %1</source>
        <translation>Evento: %1</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>en %1</translation>
    </message>
    <message>
        <source>Genus %1, components %2</source>
        <translation>Género %1, componentes %2</translation>
    </message>
    <message>
        <source>Edit by hand: %1 → %2</source>
        <translation>Edición a mano: %1 → %2</translation>
    </message>
    <message>
        <source>Loop of %1</source>
        <translation>Lazo de %1</translation>
    </message>
    <message>
        <source>Fronts joined: %1</source>
        <translation>Frentes unidos: %1</translation>
    </message>
    <message>
        <source>Boundary polygons of %1 vertices</source>
        <translation>Polígonos de borde de %1 vértices</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>Dejar que ocurra</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Omitir</translation>
    </message>
    <message>
        <source>Keep apart here</source>
        <translation>Mantener separado aquí</translation>
    </message>
    <message>
        <source>Goes back to the step before this edit, and on without it</source>
        <translation>Vuelve al paso anterior a esta edición y sigue sin ella</translation>
    </message>
    <message>
        <source>Goes back to the step before; grown on from there, this does not happen</source>
        <translation>Vuelve al paso anterior; creciendo desde allí, esto no ocurre</translation>
    </message>
    <message>
        <source>From the shown step on, what is held here may happen</source>
        <translation>Desde el paso mostrado puede ocurrir lo que aquí se retiene</translation>
    </message>
    <message>
        <source>The step is worked out again…</source>
        <translation>Se recalcula el paso…</translation>
    </message>
    <message>
        <source>The mesh was not opened here: there are no stages to show.</source>
        <translation>La malla no se abrió aquí: no hay etapas que mostrar.</translation>
    </message>
    <message>
        <source>Nothing was refined here: the polygons were simple.</source>
        <translation>Aquí no se refinó nada: los polígonos eran simples.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::EventTable</name>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Evento</translation>
    </message>
    <message>
        <source>Place (LPS)</source>
        <translation>Lugar (LPS)</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>Género</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Partes</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ExportPanel</name>
    <message>
        <source>Surface or label map</source>
        <translation>Superficie o mapa de etiquetas</translation>
    </message>
    <message>
        <source>Nothing has grown yet. Place a seed and start the growth first.</source>
        <translation>Aún no ha crecido nada. Ponga antes una semilla e inicie el crecimiento.</translation>
    </message>
    <message>
        <source>All objects in one file</source>
        <translation>Todos los objetos en un archivo</translation>
    </message>
    <message>
        <source>The active object</source>
        <translation>El objeto activo</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objetos</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>A surface keeps all detail; a label map has the voxels of the volume</source>
        <translation>Una superficie conserva todo el detalle; un mapa de etiquetas tiene los vóxeles del volumen</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Coordenadas</translation>
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
        <translation>x hacia la izquierda del paciente, y hacia atrás, como en DICOM e ITK</translation>
    </message>
    <message>
        <source>x to the patient's right, y to the front, as in NIfTI and 3D Slicer</source>
        <translation>x hacia la derecha del paciente, y hacia delante, como en NIfTI y 3D Slicer</translation>
    </message>
    <message>
        <source>Why nothing is written</source>
        <translation>Por qué no se escribe nada</translation>
    </message>
    <message>
        <source>What is written</source>
        <translation>Lo que se escribe</translation>
    </message>
    <message>
        <source>STL surface, binary</source>
        <translation>Superficie STL, binaria</translation>
    </message>
    <message>
        <source>VTP surface (VTK)</source>
        <translation>Superficie VTP (VTK)</translation>
    </message>
    <message>
        <source>PLY surface, binary</source>
        <translation>Superficie PLY, binaria</translation>
    </message>
    <message>
        <source>OBJ surface</source>
        <translation>Superficie OBJ</translation>
    </message>
    <message>
        <source>3MF surface, to print</source>
        <translation>Superficie 3MF, para imprimir</translation>
    </message>
    <message>
        <source>NIfTI label map</source>
        <translation>Mapa de etiquetas NIfTI</translation>
    </message>
    <message>
        <source>NRRD label map</source>
        <translation>Mapa de etiquetas NRRD</translation>
    </message>
    <message>
        <source>MetaImage label map</source>
        <translation>Mapa de etiquetas MetaImage</translation>
    </message>
    <message>
        <source>3D Slicer segmentation</source>
        <translation>Segmentación de 3D Slicer</translation>
    </message>
    <message>
        <source>DICOM segmentation</source>
        <translation>Segmentación DICOM</translation>
    </message>
    <message>
        <source>DICOM with STL surface</source>
        <translation>DICOM con superficie STL</translation>
    </message>
    <message>
        <source>Gmsh tetrahedra</source>
        <translation>Tetraedros Gmsh</translation>
    </message>
    <message>
        <source>VTK tetrahedra</source>
        <translation>Tetraedros VTK</translation>
    </message>
    <message>
        <source>Abaqus tetrahedra</source>
        <translation>Tetraedros Abaqus</translation>
    </message>
    <message>
        <source>Without what names the patient</source>
        <translation>Sin datos del paciente</translation>
    </message>
    <message>
        <source>What is being written</source>
        <translation>Lo que se está escribiendo</translation>
    </message>
    <message>
        <source>A file is being written</source>
        <translation>Se está escribiendo un archivo</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Cancel writing</source>
        <translation>Cancelar la escritura</translation>
    </message>
    <message>
        <source>Writing %1…</source>
        <translation>Escribiendo %1…</translation>
    </message>
    <message>
        <source>It was cancelled: nothing was written.</source>
        <translation>Cancelado: no se escribió nada.</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>All four views</source>
        <translation>Las cuatro vistas</translation>
    </message>
    <message>
        <source>%1 view</source>
        <translation>Vista %1</translation>
    </message>
    <message>
        <source>Picture of</source>
        <translation>Imagen de</translation>
    </message>
    <message>
        <source>Which view is written as PNG</source>
        <translation>Qué vista se escribe como PNG</translation>
    </message>
    <message>
        <source>Report and session</source>
        <translation>Informe y sesión</translation>
    </message>
    <message>
        <source>The report holds every parameter, number and event. A session opens here again, and “handlebody-cli replay” makes the same mesh of it.</source>
        <translation>El informe contiene todos los parámetros, números y eventos. Una sesión se vuelve a abrir aquí, y «handlebody-cli replay» hace de ella la misma malla.</translation>
    </message>
    <message>
        <source>Objects: %1; %2 together.</source>
        <translation>Objetos: %1; %2 en total.</translation>
    </message>
    <message>
        <source>Without a surface: %1.</source>
        <translation>Sin superficie: %1.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Made with earlier surfaces: %1. Nothing is written if any of them meet.</source>
        <translation>Hechos con superficies anteriores: %1. No se escribe nada si alguno se toca.</translation>
    </message>
    <message>
        <source>Nothing is left of the surface at this iteration.</source>
        <translation>En esta iteración no queda nada de la superficie.</translation>
    </message>
    <message>
        <source>Iteration %1: %2, %3</source>
        <translation>Iteración %1: %2, %3</translation>
    </message>
    <message>
        <source>What was bettered</source>
        <translation>Lo que se mejoró</translation>
    </message>
    <message>
        <source>glTF scene, to view</source>
        <translation>Escena glTF, para ver</translation>
    </message>
    <message>
        <source>Better thin triangles</source>
        <translation>Mejorar triángulos finos</translation>
    </message>
    <message>
        <source>Triangles with an angle under 15° and edges sharper than 20°, which a solver cannot use, are made better in what is written; the surface goes no farther than a tenth of a voxel. The session keeps this choice.</source>
        <translation>Los triángulos con un ángulo menor de 15° y las aristas más agudas de 20°, que un programa de cálculo no puede usar, se mejoran en lo que se escribe; la superficie no se aleja más de una décima de vóxel. La sesión conserva esta elección.</translation>
    </message>
    <message>
        <source>Bettering the triangles of “%1”…</source>
        <translation>Mejorando los triángulos de «%1»…</translation>
    </message>
    <message>
        <source>Bettering the triangles…</source>
        <translation>Mejorando los triángulos…</translation>
    </message>
    <message>
        <source>Creator</source>
        <translation>Creador</translation>
    </message>
    <message>
        <source>Who made it, as DICOM writes names: Family^Given. May stay empty</source>
        <translation>Quién lo ha hecho, como DICOM escribe los nombres: Apellido^Nombre. Puede quedar vacío</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Descripción</translation>
    </message>
    <message>
        <source>What it is for. May stay empty</source>
        <translation>Para qué es. Puede quedar vacío</translation>
    </message>
    <message>
        <source>ITK-SNAP label description</source>
        <translation>Descripción de etiquetas para ITK-SNAP</translation>
    </message>
    <message>
        <source>DICOM files, report and measures are written without patient, study, dates and names of files, and the names that are suggested do not tell the volume's. In place of saving the session one is exported that does not say where its volume is: it asks for it when it is opened.</source>
        <translation>Los archivos DICOM, el informe y las medidas se escriben sin paciente, estudio, fechas ni nombres de archivos, y los nombres propuestos no revelan el del volumen. En lugar de guardar la sesión se exporta una que no dice dónde está su volumen: lo pide al abrirla.</translation>
    </message>
    <message>
        <source>Each object in a file of its own</source>
        <translation>Cada objeto en un archivo propio</translation>
    </message>
    <message>
        <source>What a file holds: names and colours stay apart where it can; to the name of a file of one object its name is added</source>
        <translation>Lo que contiene un archivo: nombres y colores quedan separados donde puede; al nombre del archivo de un solo objeto se le añade el del objeto</translation>
    </message>
    <message>
        <source>Nothing is left of the file, nor of those that wait</source>
        <translation>No queda nada del archivo ni de los que esperan</translation>
    </message>
    <message>
        <source>Waiting: %1.</source>
        <translation>En espera: %1.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::FileWork</name>
    <message>
        <source>%1 is written.</source>
        <translation>%1 está escrito.</translation>
    </message>
    <message>
        <source>The session is saved as %1.</source>
        <translation>La sesión está guardada como %1.</translation>
    </message>
    <message>
        <source>A replay grows anew: %1.</source>
        <translation>Una repetición hace crecer de nuevo: %1.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Open a volume or a session</source>
        <translation>Abrir un volumen o una sesión</translation>
    </message>
    <message>
        <source>Open a folder with a DICOM series</source>
        <translation>Abrir una carpeta con una serie DICOM</translation>
    </message>
    <message>
        <source>Enter the spacing</source>
        <translation>Introducir el espaciado</translation>
    </message>
    <message>
        <source>The sample is not installed with this program.</source>
        <translation>El ejemplo no está instalado con este programa.</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Trabajo sin guardar</translation>
    </message>
    <message>
        <source>Save the seeds and parameters first?</source>
        <translation>¿Guardar antes las semillas y los parámetros?</translation>
    </message>
    <message>
        <source>They are kept in a session, from which the same surface can be grown again.</source>
        <translation>Se guardan en una sesión, de la que puede volver a crecer la misma superficie.</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Guardar la sesión</translation>
    </message>
    <message>
        <source>Sessions (*.json)</source>
        <translation>Sesiones (*.json)</translation>
    </message>
    <message>
        <source>Export the result</source>
        <translation>Exportar el resultado</translation>
    </message>
    <message>
        <source>Export the report</source>
        <translation>Exportar el informe</translation>
    </message>
    <message>
        <source>Export a picture</source>
        <translation>Exportar una imagen</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>No se puede escribir %1: %2.</translation>
    </message>
    <message>
        <source>The program ended unexpectedly last time. Its seeds and parameters were kept.</source>
        <translation>El programa terminó inesperadamente la última vez. Se conservaron sus semillas y parámetros.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Restaurar</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Volumes and sessions (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.tif *.tiff *.dcm *.json);;All files (*)</source>
        <translation>Volúmenes y sesiones (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.tif *.tiff *.dcm *.json);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Open a mesh or a label map</source>
        <translation>Abrir una malla o un mapa de etiquetas</translation>
    </message>
    <message>
        <source>Open objects</source>
        <translation>Abrir objetos</translation>
    </message>
    <message>
        <source>Making surfaces of %1…</source>
        <translation>Creando las superficies de %1…</translation>
    </message>
    <message>
        <source>%1 is open as: %2.</source>
        <translation>%1 está abierto como: %2.</translation>
    </message>
    <message>
        <source>%1 is a surface: open the volume first that it lies in.</source>
        <translation>%1 es una superficie: abra antes el volumen en que está.</translation>
    </message>
    <message>
        <source>Export a 4D label map</source>
        <translation>Exportar un mapa de etiquetas 4D</translation>
    </message>
    <message>
        <source>Export the meshes of all frames</source>
        <translation>Exportar las mallas de todos los fotogramas</translation>
    </message>
    <message>
        <source>Choose the file…</source>
        <translation>Elegir el archivo…</translation>
    </message>
    <message>
        <source>Choose the folder…</source>
        <translation>Elegir la carpeta…</translation>
    </message>
    <message>
        <source>Choose what the session needs</source>
        <translation>Elegir lo que la sesión necesita</translation>
    </message>
    <message>
        <source>Export an anonymous session</source>
        <translation>Exportar una sesión anónima</translation>
    </message>
    <message>
        <source>Segments overlap: what several of them hold is left to the smallest (voxels: %1). Step 4, Grow, tells it of each.</source>
        <translation>Hay segmentos que se solapan: lo que contienen varios de ellos se deja al menor (vóxeles: %1). El paso 4, Crecer, lo dice de cada uno.</translation>
    </message>
    <message>
        <source>Meshes and label maps (*.stl *.vtp *.ply *.obj *.3mf *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.dcm);;All files (*)</source>
        <translation>Mallas y mapas de etiquetas (*.stl *.vtp *.ply *.obj *.3mf *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.dcm);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>There already: %1. Replace what is there?</source>
        <translation>Ya existen: %1. ¿Reemplazar lo que hay?</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 más</translation>
    </message>
    <message>
        <source>A file is being written. The window closes when it is done.</source>
        <translation>Se está escribiendo un archivo. La ventana se cerrará cuando esté listo.</translation>
    </message>
    <message>
        <source>Stay open</source>
        <translation>Seguir abierta</translation>
    </message>
    <message>
        <source>%1 was changed elsewhere since it was opened or saved here. Replace what is there?</source>
        <translation>%1 se modificó en otro lugar desde que se abrió o guardó aquí. ¿Reemplazar lo que hay?</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Sobrescribir</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Guardar como…</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::FrameSlider</name>
    <message>
        <source>Frame</source>
        <translation>Fotograma</translation>
    </message>
    <message>
        <source>&lt;p&gt;Time: the frames of the volume. A ring is the frame the surface is grown in, dots are frames it was carried to: orange with a warning, red where it failed. Click or drag to go there.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Tiempo: los fotogramas del volumen. Un anillo es el fotograma en que crece la superficie; los puntos, aquellos a los que se propagó: naranja con una advertencia, rojo donde falló. Haga clic o arrastre para ir allí.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::GrowPanel</name>
    <message>
        <source>not closed</source>
        <translation>no cerrada</translation>
    </message>
    <message>
        <source>not manifold</source>
        <translation>no variedad</translation>
    </message>
    <message>
        <source>not oriented</source>
        <translation>no orientada</translation>
    </message>
    <message>
        <source>self-intersections: %1</source>
        <translation>autointersecciones: %1</translation>
    </message>
    <message>
        <source>parts that lie wrongly in each other: %1</source>
        <translation>partes mal anidadas: %1</translation>
    </message>
    <message>
        <source>self-intersections not checked</source>
        <translation>autointersecciones no comprobadas</translation>
    </message>
    <message>
        <source>Finished: the surface is at rest</source>
        <translation>Terminado: la superficie está en reposo</translation>
    </message>
    <message>
        <source>Stopped at the iteration limit</source>
        <translation>Detenido en el límite de iteraciones</translation>
    </message>
    <message>
        <source>Finished: nothing is left of the surface</source>
        <translation>Terminado: no queda nada de la superficie</translation>
    </message>
    <message>
        <source>At rest, but parts that could not be mended would still move</source>
        <translation>En reposo, pero partes que no se pudieron arreglar aún se moverían</translation>
    </message>
    <message>
        <source>Stuck: no part of a step could be kept</source>
        <translation>Bloqueado: no se pudo conservar ninguna parte de un paso</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Terminado</translation>
    </message>
    <message>
        <source>⚠ Worth a look</source>
        <translation>⚠ Conviene mirar</translation>
    </message>
    <message>
        <source>iteration %1 of %2</source>
        <translation>iteración %1 de %2</translation>
    </message>
    <message>
        <source>Preparing the image…</source>
        <translation>Preparando la imagen…</translation>
    </message>
    <message>
        <source>Growing</source>
        <translation>Creciendo</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pausa</translation>
    </message>
    <message>
        <source>No seed yet</source>
        <translation>Aún sin semilla</translation>
    </message>
    <message>
        <source>Ready to grow</source>
        <translation>Listo para crecer</translation>
    </message>
    <message>
        <source>Nothing grew</source>
        <translation>No creció nada</translation>
    </message>
    <message>
        <source>These clicks mean another object: begun anew at iteration %1</source>
        <translation>Estos puntos indican otro objeto: empezado de nuevo en la iteración %1</translation>
    </message>
    <message>
        <source>Clicks changed at iteration %1: gone on from there</source>
        <translation>Puntos cambiados en la iteración %1: se siguió desde allí</translation>
    </message>
    <message>
        <source>Start grows the surface from the seeds. You may pause, go back exactly, change a click or a parameter and go on from there at any time.</source>
        <translation>Iniciar hace crecer la superficie desde las semillas. Puede pausar, retroceder con exactitud, cambiar un punto o un parámetro y seguir desde allí en cualquier momento.</translation>
    </message>
    <message>
        <source>State of the growth</source>
        <translation>Estado del crecimiento</translation>
    </message>
    <message>
        <source>Why it did not grow</source>
        <translation>Por qué no creció</translation>
    </message>
    <message>
        <source>Doubts about the surface</source>
        <translation>Dudas sobre la superficie</translation>
    </message>
    <message>
        <source>Steps per frame</source>
        <translation>Pasos por imagen</translation>
    </message>
    <message>
        <source>How many iterations the surface goes on between two pictures of it</source>
        <translation>Cuántas iteraciones avanza la superficie entre dos imágenes</translation>
    </message>
    <message>
        <source>Pause at a leak</source>
        <translation>Pausa ante una fuga</translation>
    </message>
    <message>
        <source>The growth pauses where the surface has come through a passage much narrower than what lies on both sides of it</source>
        <translation>El crecimiento se detiene donde la superficie pasó por un paso mucho más estrecho que lo que hay a ambos lados</translation>
    </message>
    <message>
        <source>Surface now</source>
        <translation>Superficie actual</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificado</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Volume enclosed by the surface</source>
        <translation>Volumen encerrado por la superficie</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Area of the surface</source>
        <translation>Área de la superficie</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Componentes</translation>
    </message>
    <message>
        <source>Connected parts of the surface</source>
        <translation>Partes conexas de la superficie</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>Género</translation>
    </message>
    <message>
        <source>Holes as in a ring: in all, and of each component</source>
        <translation>Agujeros como en un anillo: en total y de cada componente</translation>
    </message>
    <message>
        <source>Euler number</source>
        <translation>Número de Euler</translation>
    </message>
    <message>
        <source>Vertices minus edges plus faces</source>
        <translation>Vértices menos aristas más caras</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Vértices</translation>
    </message>
    <message>
        <source>Vertices of the mesh</source>
        <translation>Vértices de la malla</translation>
    </message>
    <message>
        <source>Nothing is left of the surface</source>
        <translation>No queda nada de la superficie</translation>
    </message>
    <message>
        <source>✓ Closed, manifold, free of self-intersections</source>
        <translation>✓ Cerrada, variedad, sin autointersecciones</translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>As it was opened: nothing grows</source>
        <translation>Tal como se abrió: no crece nada</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::HeldSection</name>
    <message>
        <source>What is held back</source>
        <translation>Lo que se retiene</translation>
    </message>
    <message>
        <source>Nothing is held back.</source>
        <translation>No se retiene nada.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>Where (mm LPS)</source>
        <translation>Dónde (mm LPS)</translation>
    </message>
    <message>
        <source>What is held back, each with its place</source>
        <translation>Lo que se retiene, cada cosa con su lugar</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>Levantar</translation>
    </message>
    <message>
        <source>At most %1 components</source>
        <translation>Componentes: %1 como máximo</translation>
    </message>
    <message>
        <source>Lift the limit</source>
        <translation>Levantar el límite</translation>
    </message>
    <message>
        <source>Genus at most %1</source>
        <translation>Género: %1 como máximo</translation>
    </message>
    <message>
        <source>May break the limits</source>
        <translation>Puede superar los límites</translation>
    </message>
    <message>
        <source>Allow no more</source>
        <translation>No permitir más</translation>
    </message>
    <message>
        <source>Veto at iteration %1</source>
        <translation>Veto en la iteración %1</translation>
    </message>
    <message>
        <source>Lift the veto</source>
        <translation>Levantar el veto</translation>
    </message>
    <message>
        <source>Pin at iteration %1</source>
        <translation>Fijación en la iteración %1</translation>
    </message>
    <message>
        <source>%1, %2 balls</source>
        <translation>%1, %2 bolas</translation>
    </message>
    <message>
        <source>Lift the pin</source>
        <translation>Levantar la fijación</translation>
    </message>
    <message>
        <source>Disc, radius %1</source>
        <translation>Disco, radio %1</translation>
    </message>
    <message>
        <source>Lift the disc</source>
        <translation>Levantar el disco</translation>
    </message>
    <message>
        <source>Walls of %1</source>
        <translation>Barreras de %1</translation>
    </message>
    <message>
        <source>Lift the map of walls</source>
        <translation>Levantar el mapa de barreras</translation>
    </message>
    <message>
        <source>Held: %1</source>
        <translation>Retenido: %1</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>Dejar que ocurra</translation>
    </message>
    <message>
        <source>From the shown iteration on the chosen one holds nothing back</source>
        <translation>Desde la iteración mostrada lo elegido no retiene nada</translation>
    </message>
    <message>
        <source>Held, as you decided</source>
        <translation>Retenido, como usted decidió</translation>
    </message>
    <message>
        <source>Decide again</source>
        <translation>Decidir de nuevo</translation>
    </message>
    <message>
        <source>To decide: %1</source>
        <translation>Por decidir: %1</translation>
    </message>
    <message>
        <source>%1 around</source>
        <translation>%1 de contorno</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::HelpWindow</name>
    <message>
        <source>Handlebody: help</source>
        <translation>Handlebody: ayuda</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guía</translation>
    </message>
    <message>
        <source>Keyboard and mouse</source>
        <translation>Teclado y ratón</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Acerca de</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::HistogramView</name>
    <message>
        <source>Histogram with the object's range</source>
        <translation>Histograma con el intervalo del objeto</translation>
    </message>
    <message>
        <source>&lt;p&gt;How often each intensity occurs (square root). Drag the ends of the object's range; with the keyboard: Up and Down choose an end, Left and Right move it.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Frecuencia de cada intensidad (raíz cuadrada). Arrastre los extremos del intervalo del objeto; con el teclado: Arriba y Abajo eligen un extremo, Izquierda y Derecha lo mueven.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>From %1 to %2</source>
        <translation>De %1 a %2</translation>
    </message>
    <message>
        <source>No range yet</source>
        <translation>Aún sin intervalo</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::LabelChoice</name>
    <message>
        <source>Label %1</source>
        <translation>Etiqueta %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>&amp;Labels to open</source>
        <translation>&amp;Etiquetas que se abren</translation>
    </message>
    <message>
        <source>Labels to open</source>
        <translation>Etiquetas que se abren</translation>
    </message>
    <message>
        <source>Each that is checked becomes an object, called and coloured as the file says</source>
        <translation>Cada una de las marcadas pasa a ser un objeto, con el nombre y el color que da el archivo</translation>
    </message>
    <message>
        <source>&amp;All</source>
        <translation>To&amp;das</translation>
    </message>
    <message>
        <source>Checks all labels</source>
        <translation>Marca todas las etiquetas</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Ninguna</translation>
    </message>
    <message>
        <source>Checks no label</source>
        <translation>No marca ninguna etiqueta</translation>
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
        <translation>Radio en la cruz</translation>
    </message>
    <message>
        <source>Of the ball in which the surface is pinned or smoothed, and how far along it a pull reaches</source>
        <translation>De la bola en que la superficie se fija o se suaviza, y hasta dónde llega un tirón</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Fijar</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Suavizar</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Estirar</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagital</translation>
    </message>
    <message>
        <source>Cut as the axial slices lie</source>
        <translation>Cortar como los cortes axiales</translation>
    </message>
    <message>
        <source>Cut as the coronal slices lie</source>
        <translation>Cortar como los cortes coronales</translation>
    </message>
    <message>
        <source>Cut as the sagittal slices lie</source>
        <translation>Cortar como los cortes sagitales</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Ambos</translation>
    </message>
    <message>
        <source>Superior</source>
        <translation>Superior</translation>
    </message>
    <message>
        <source>Inferior</source>
        <translation>Inferior</translation>
    </message>
    <message>
        <source>Both sides of the cut stay</source>
        <translation>Quedan ambos lados del corte</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Cortar</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>Posterior</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Izquierda</translation>
    </message>
    <message>
        <source>Anterior</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Keep: %1</source>
        <translation>Conservar: %1</translation>
    </message>
    <message>
        <source>Only what lies on this side of the plane stays</source>
        <translation>Solo queda lo que está en este lado del plano</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::MainWindow</name>
    <message>
        <source>Steps</source>
        <translation>Pasos</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Barreras</translation>
    </message>
    <message>
        <source>Paint in the slices where the surface may not go, from the shown iteration on. Ctrl+wheel changes the radius.</source>
        <translation>Pinte en los cortes adónde no puede ir la superficie, desde la iteración mostrada. Ctrl+rueda cambia el radio.</translation>
    </message>
    <message>
        <source>On the surface</source>
        <translation>Sobre la superficie</translation>
    </message>
    <message>
        <source>With the brush, in the slices and in 3D: drag to pin or unpin, click to smooth, drag a point to pull it. The radius is the same. A line drawn across it in a slice cuts it.</source>
        <translation>Con el pincel, en los cortes y en 3D: arrastrar para fijar o soltar, clic para suavizar, arrastrar un punto para estirar. El radio es el mismo. Una línea que la cruza en un corte la corta.</translation>
    </message>
    <message>
        <source>Held back</source>
        <translation>Retenido</translation>
    </message>
    <message>
        <source>Limits, vetoes, pins and discs. The crosshair goes to the chosen one; lifted, it holds no more from the shown iteration on.</source>
        <translation>Límites, vetos, fijaciones y discos. La cruz va a lo elegido; levantado, deja de retener desde la iteración mostrada.</translation>
    </message>
    <message>
        <source>At the crosshair</source>
        <translation>En la cruz</translation>
    </message>
    <message>
        <source>A pin holds the surface in a ball. To smooth, pull and cut is the next step.</source>
        <translation>Una fijación sujeta la superficie en una bola. Suavizar, estirar y cortar son el siguiente paso.</translation>
    </message>
    <message>
        <source>The surface is pinned here from iteration %1 on.</source>
        <translation>La superficie está fijada aquí desde la iteración %1.</translation>
    </message>
    <message>
        <source>Tunnels and pieces</source>
        <translation>Túneles y piezas</translation>
    </message>
    <message>
        <source>What the shown surface holds, and what can be done to it: each edit is the next step.</source>
        <translation>Lo que contiene la superficie mostrada y lo que se puede hacer: cada edición es el siguiente paso.</translation>
    </message>
    <message>
        <source>Several files were dropped; the first one is opened. For a DICOM series drop its folder.</source>
        <translation>Se soltaron varios archivos; se abre el primero. Para una serie DICOM, suelte su carpeta.</translation>
    </message>
    <message>
        <source>The language changes when the program is started again.</source>
        <translation>El idioma cambia cuando se reinicia el programa.</translation>
    </message>
    <message>
        <source>P&amp;ause</source>
        <translation>Pau&amp;sa</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>Se&amp;guir</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Iniciar</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1: %2, was %3.</source>
        <translation>%1: %2, era %3.</translation>
    </message>
    <message>
        <source>A leak at iteration %1: %2.</source>
        <translation>Una fuga en la iteración %1: %2.</translation>
    </message>
    <message>
        <source>Wall here</source>
        <translation>Barrera aquí</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Volver</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Seguir</translation>
    </message>
    <message>
        <source>“%1” came through a narrow passage.</source>
        <translation>«%1» pasó por un paso estrecho.</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>Medidas</translation>
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
        <translation>Quitar todas las barreras</translation>
    </message>
    <message>
        <source>Remove all pins</source>
        <translation>Quitar todas las fijaciones</translation>
    </message>
    <message>
        <source>The surface is already where the wall is.</source>
        <translation>La superficie ya está donde está la barrera.</translation>
    </message>
    <message>
        <source>Go back to before it came in here</source>
        <translation>Volver a antes de que llegara</translation>
    </message>
    <message>
        <source>Push it out</source>
        <translation>Empujarla fuera</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>Dejar que ocurra</translation>
    </message>
    <message>
        <source>Hold it</source>
        <translation>Retener</translation>
    </message>
    <message>
        <source>“%1” has paused: a change of its topology is held, for you to decide.</source>
        <translation>«%1» está en pausa: se retiene un cambio de su topología, para que usted decida.</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>En el tiempo</translation>
    </message>
    <message>
        <source>&amp;Stop playing</source>
        <translation>Detener la &amp;reproducción</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Reproducir</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Ca&amp;ncelar</translation>
    </message>
    <message>
        <source>&amp;Over time</source>
        <translation>En el &amp;tiempo</translation>
    </message>
    <message>
        <source>These objects lose their surfaces, too, and undo does not bring them back: %1. Grow in this frame?</source>
        <translation>Estos objetos también pierden sus superficies, y deshacer no las recupera: %1. ¿Crecer en este fotograma?</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Grow in this frame</source>
        <translation>Crecer en este fotograma</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::Measurements</name>
    <message>
        <source>Ruler %1</source>
        <translation>Regla %1</translation>
    </message>
    <message>
        <source>Angle %1</source>
        <translation>Ángulo %1</translation>
    </message>
    <message>
        <source>Add ruler</source>
        <translation>Añadir regla</translation>
    </message>
    <message>
        <source>Add angle</source>
        <translation>Añadir ángulo</translation>
    </message>
    <message>
        <source>Move ruler</source>
        <translation>Mover regla</translation>
    </message>
    <message>
        <source>Move angle</source>
        <translation>Mover ángulo</translation>
    </message>
    <message>
        <source>Delete ruler</source>
        <translation>Eliminar regla</translation>
    </message>
    <message>
        <source>Delete angle</source>
        <translation>Eliminar ángulo</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::MeasuresPanel</name>
    <message>
        <source>What is measured</source>
        <translation>Lo que se mide</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objetos</translation>
    </message>
    <message>
        <source>Rulers and angles</source>
        <translation>Reglas y ángulos</translation>
    </message>
    <message>
        <source>Centre line</source>
        <translation>Línea central</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Sensibilidad</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::MessageBar</name>
    <message>
        <source>Warning</source>
        <translation>Advertencia</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>Información</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Mensaje</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>Cerrar el mensaje</translation>
    </message>
    <message>
        <source>Close the message (Esc)</source>
        <translation>Cerrar el mensaje (Esc)</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ObjectChoice</name>
    <message>
        <source>The only one: %1</source>
        <translation>El único: %1</translation>
    </message>
    <message>
        <source>%1 of %2 by size: %3</source>
        <translation>%1 de %2 por tamaño: %3</translation>
    </message>
    <message>
        <source>%1 (likeliest)</source>
        <translation>%1 (el más probable)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objeto</translation>
    </message>
    <message>
        <source>Which object is taken</source>
        <translation>Qué objeto se toma</translation>
    </message>
    <message>
        <source>Whether the choice is sure</source>
        <translation>Si la elección es segura</translation>
    </message>
    <message>
        <source>A close choice: look at the others, too.</source>
        <translation>Una elección ajustada: mire también los otros.</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Menor</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Mayor</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ObjectDialog</name>
    <message>
        <source>Properties of the object</source>
        <translation>Propiedades del objeto</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>What the object is called in the list and in files that hold names</source>
        <translation>Cómo se llama el objeto en la lista y en archivos que guardan nombres</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nombre</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Of its surface and outlines, and in files that hold colours</source>
        <translation>De su superficie y contornos, y en archivos que guardan colores</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>&amp;Color</translation>
    </message>
    <message>
        <source>Term</source>
        <translation>Término</translation>
    </message>
    <message>
        <source>What it is, as a code of SNOMED CT; gives the colour, too</source>
        <translation>Qué es, como código de SNOMED CT; da también el color</translation>
    </message>
    <message>
        <source>&amp;Term</source>
        <translation>&amp;Término</translation>
    </message>
    <message>
        <source>Label value</source>
        <translation>Valor de etiqueta</translation>
    </message>
    <message>
        <source>Of its voxels in a label map</source>
        <translation>De sus vóxeles en un mapa de etiquetas</translation>
    </message>
    <message>
        <source>&amp;Label value</source>
        <translation>&amp;Valor de etiqueta</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Qué está mal</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objeto</translation>
    </message>
    <message>
        <source>Colour of the object</source>
        <translation>Color del objeto</translation>
    </message>
    <message>
        <source>Change object</source>
        <translation>Cambiar objeto</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ObjectMeasuresPage</name>
    <message>
        <source>Measures of the objects</source>
        <translation>Medidas de los objetos</translation>
    </message>
    <message>
        <source>More about the chosen object</source>
        <translation>Más sobre el objeto elegido</translation>
    </message>
    <message>
        <source>State of the measures</source>
        <translation>Estado de las medidas</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>Grosor de pared</translation>
    </message>
    <message>
        <source>The distance of two surfaces over their area: of two objects, or of an object and its own cavities</source>
        <translation>La distancia de dos superficies sobre su área: de dos objetos, o de un objeto y sus cavidades</translation>
    </message>
    <message>
        <source>How much is measured</source>
        <translation>Cuánto se ha medido</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>Measure the surfaces as they are shown</source>
        <translation>Medir las superficies como se muestran</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy the table, to paste it into a spreadsheet</source>
        <translation>Copiar la tabla, para pegarla en una hoja de cálculo</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Guardar como CSV…</translation>
    </message>
    <message>
        <source>The same table as “handlebody-cli measure --csv” writes</source>
        <translation>La misma tabla que escribe «handlebody-cli measure --csv»</translation>
    </message>
    <message>
        <source>Save as JSON…</source>
        <translation>Guardar como JSON…</translation>
    </message>
    <message>
        <source>The same as “handlebody-cli measure --json” writes</source>
        <translation>Lo mismo que escribe «handlebody-cli measure --json»</translation>
    </message>
    <message>
        <source>Save the measures</source>
        <translation>Guardar las medidas</translation>
    </message>
    <message>
        <source>No wall thickness</source>
        <translation>Sin grosor de pared</translation>
    </message>
    <message>
        <source>Wall of “%1” around its cavities</source>
        <translation>Pared de «%1» alrededor de sus cavidades</translation>
    </message>
    <message>
        <source>Wall from “%1” to “%2”</source>
        <translation>Pared de «%1» a «%2»</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>There is no surface to measure yet: grow one first.</source>
        <translation>Aún no hay superficie que medir: haga crecer una primero.</translation>
    </message>
    <message>
        <source>Measuring. What is shown is of earlier surfaces.</source>
        <translation>Midiendo. Lo mostrado es de superficies anteriores.</translation>
    </message>
    <message>
        <source>Measuring.</source>
        <translation>Midiendo.</translation>
    </message>
    <message>
        <source>These are measures of earlier surfaces.</source>
        <translation>Estas medidas son de superficies anteriores.</translation>
    </message>
    <message>
        <source>Nothing is measured yet.</source>
        <translation>Aún no se ha medido nada.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ObjectsPanel</name>
    <message>
        <source>preparing</source>
        <translation>preparando</translation>
    </message>
    <message>
        <source>not grown</source>
        <translation>sin crecer</translation>
    </message>
    <message>
        <source>no seed</source>
        <translation>sin semilla</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objetos</translation>
    </message>
    <message>
        <source>What the active object is made with</source>
        <translation>Con qué se hace el objeto activo</translation>
    </message>
    <message>
        <source>%1, label value %2</source>
        <translation>%1, valor de etiqueta %2</translation>
    </message>
    <message>
        <source>Made with an earlier “%1”</source>
        <translation>Hecho con un «%1» anterior</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>Ocultar %1</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>Mostrar %1</translation>
    </message>
    <message>
        <source>Its surface is drawn: hide it</source>
        <translation>Se dibuja su superficie: ocultarla</translation>
    </message>
    <message>
        <source>Its surface is hidden: show it</source>
        <translation>Su superficie está oculta: mostrarla</translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <translation>Desbloquear %1</translation>
    </message>
    <message>
        <source>Lock %1</source>
        <translation>Bloquear %1</translation>
    </message>
    <message>
        <source>Nothing of it is changed: unlock it</source>
        <translation>No se cambia nada de él: desbloquearlo</translation>
    </message>
    <message>
        <source>Let nothing of it be changed</source>
        <translation>No dejar cambiar nada de él</translation>
    </message>
    <message>
        <source>Waits for “%1”, which comes before it and grows.</source>
        <translation>Espera a «%1», que va antes y está creciendo.</translation>
    </message>
    <message>
        <source>Made with an earlier “%1”. Start grows it anew.</source>
        <translation>Hecho con un «%1» anterior. Iniciar lo hace crecer de nuevo.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::OpenObjectsDialog</name>
    <message>
        <source>Open objects</source>
        <translation>Abrir objetos</translation>
    </message>
    <message>
        <source>What are the surfaces of “%1”?</source>
        <translation>¿Qué son las superficies de «%1»?</translation>
    </message>
    <message>
        <source>Objects that are done stay as they are: locked, written with the others, and walls for objects that grow after them.

Others are where objects begin: they grow from there onto the image, or give ground.</source>
        <translation>Los objetos terminados quedan como están: bloqueados, escritos con los demás, y barreras para los objetos que crecen después.

Los otros son donde empiezan los objetos: crecen desde allí hacia la imagen, o ceden terreno.</translation>
    </message>
    <message>
        <source>Reading the labels…</source>
        <translation>Leyendo las etiquetas…</translation>
    </message>
    <message>
        <source>Segments that overlap</source>
        <translation>Segmentos que se solapan</translation>
    </message>
    <message>
        <source>Segments may overlap here: voxels that several of those that are opened hold are left to the smallest of them.</source>
        <translation>Aquí pueden solaparse segmentos: los vóxeles que contienen varios de los que se abren se dejan al menor de ellos.</translation>
    </message>
    <message>
        <source>How the surfaces are made</source>
        <translation>Cómo se hacen las superficies</translation>
    </message>
    <message>
        <source>Only the largest &amp;part</source>
        <translation>Solo la &amp;parte mayor</translation>
    </message>
    <message>
        <source>Only the largest part</source>
        <translation>Solo la parte mayor</translation>
    </message>
    <message>
        <source>Of each label only the part with the most voxels: those that share a side</source>
        <translation>De cada etiqueta solo la parte con más vóxeles: los que comparten una cara</translation>
    </message>
    <message>
        <source>&amp;Smoothing</source>
        <translation>&amp;Suavizado</translation>
    </message>
    <message>
        <source>A voxel along each axis</source>
        <translation>Un vóxel a lo largo de cada eje</translation>
    </message>
    <message>
        <source>A length</source>
        <translation>Una longitud</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Suavizado</translation>
    </message>
    <message>
        <source>How far the steps between the voxels are smoothed, as a standard deviation. None: the surface goes midway between the voxels, steps and all.</source>
        <translation>Hasta dónde se suavizan los escalones entre los vóxeles, como desviación estándar. Ninguno: la superficie pasa a medio camino entre los vóxeles, con todos los escalones.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Length of the smoothing</source>
        <translation>Longitud del suavizado</translation>
    </message>
    <message>
        <source>Standard deviation; 0: none, steps and all</source>
        <translation>Desviación estándar; 0: ninguno, con todos los escalones</translation>
    </message>
    <message>
        <source>No more &amp;tunnels than</source>
        <translation>No más túne&amp;les que</translation>
    </message>
    <message>
        <source>No more tunnels than</source>
        <translation>No más túneles que</translation>
    </message>
    <message>
        <source>In each surface, all of its parts together: tunnels are filled, or what goes around them is cut, whichever changes the fewest voxels</source>
        <translation>En cada superficie, todas sus partes juntas: los túneles se rellenan, o se corta lo que los rodea, según lo que cambie menos vóxeles</translation>
    </message>
    <message>
        <source>Tunnels at most</source>
        <translation>Túneles como máximo</translation>
    </message>
    <message>
        <source>Tunnels, as in a ring</source>
        <translation>Túneles, como en un anillo</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Terminados</translation>
    </message>
    <message>
        <source>To &amp;grow from</source>
        <translation>Para &amp;crecer</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::OpenPanel</name>
    <message>
        <source>along the patient's axes</source>
        <translation>según los ejes del paciente</translation>
    </message>
    <message>
        <source>oblique: slices follow the volume's own axes</source>
        <translation>oblicuo: los cortes siguen los ejes del volumen</translation>
    </message>
    <message>
        <source>Open a CT, MR or ultrasound volume, a DICOM folder or a saved session; files can also be dropped on the window.</source>
        <translation>Abra un volumen de TC, RM o ecografía, una carpeta DICOM o una sesión guardada; también puede soltar archivos en la ventana.</translation>
    </message>
    <message>
        <source>Series and stacks: choose one</source>
        <translation>Series y pilas: elija una</translation>
    </message>
    <message>
        <source>Open this series</source>
        <translation>Abrir esta serie</translation>
    </message>
    <message>
        <source>Open now</source>
        <translation>Abierto ahora</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Vóxeles</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espaciado</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Extensión</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Ejes</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Advertencias</translation>
    </message>
    <message>
        <source>Time point</source>
        <translation>Instante</translation>
    </message>
    <message>
        <source>The volume has several time points; one is shown and segmented</source>
        <translation>El volumen tiene varios instantes; se muestra y segmenta uno</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Cargar</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>  (0 to %1)</source>
        <translation>  (0 a %1)</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::OverTimePanel</name>
    <message>
        <source>grown</source>
        <translation>crecida</translation>
    </message>
    <message>
        <source>corrected, from frame %1</source>
        <translation>corregida, desde %1</translation>
    </message>
    <message>
        <source>carried from frame %1</source>
        <translation>propagada desde %1</translation>
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
        <translation>Fotograma</translation>
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
        <translation>Estado</translation>
    </message>
    <message>
        <source>What has become of each frame</source>
        <translation>Qué ha sido de cada fotograma</translation>
    </message>
    <message>
        <source>How far the surface is carried</source>
        <translation>Hasta dónde se ha propagado la superficie</translation>
    </message>
    <message>
        <source>State of what is carried</source>
        <translation>Estado de lo propagado</translation>
    </message>
    <message>
        <source>Figures over time</source>
        <translation>Cifras en el tiempo</translation>
    </message>
    <message>
        <source>held</source>
        <translation>retenida</translation>
    </message>
    <message>
        <source>free</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>Topology over time</source>
        <translation>Topología en el tiempo</translation>
    </message>
    <message>
        <source>Held: no frame has other components or tunnels than the first surface. Free: it may change.</source>
        <translation>Retenida: ningún fotograma tiene otros componentes o túneles que la primera superficie. Libre: puede cambiar.</translation>
    </message>
    <message>
        <source>back</source>
        <translation>de vuelta</translation>
    </message>
    <message>
        <source>round the cycle</source>
        <translation>por el ciclo</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>Check of the way</source>
        <translation>Control del recorrido</translation>
    </message>
    <message>
        <source>Back: carried back from the ends, to see how far it is off. Round the cycle: from the last frame to the first, which lie beside each other.</source>
        <translation>De vuelta: se propaga de regreso desde los extremos, para ver cuánto se desvía. Por el ciclo: del último fotograma al primero, que son contiguos.</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Primer fotograma</translation>
    </message>
    <message>
        <source>The surface is carried from here …</source>
        <translation>La superficie se propaga desde aquí…</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Último fotograma</translation>
    </message>
    <message>
        <source>… to here</source>
        <translation>… hasta aquí</translation>
    </message>
    <message>
        <source>Topology</source>
        <translation>Topología</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Control</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Fotogramas</translation>
    </message>
    <message>
        <source>to</source>
        <translation>a</translation>
    </message>
    <message>
        <source>Check over time</source>
        <translation>Control en el tiempo</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV…</translation>
    </message>
    <message>
        <source>Plot…</source>
        <translation>Gráfica…</translation>
    </message>
    <message>
        <source>Save the curve as CSV</source>
        <translation>Guardar la curva como CSV</translation>
    </message>
    <message>
        <source>The same table as “handlebody-cli segment --curve F.csv” writes</source>
        <translation>La misma tabla que escribe «handlebody-cli segment --curve F.csv»</translation>
    </message>
    <message>
        <source>Save the curve as a plot</source>
        <translation>Guardar la curva como gráfica</translation>
    </message>
    <message>
        <source>The same picture (SVG) as “handlebody-cli segment --curve F.svg” writes</source>
        <translation>La misma imagen (SVG) que escribe «handlebody-cli segment --curve F.svg»</translation>
    </message>
    <message>
        <source>Meshes…</source>
        <translation>Mallas…</translation>
    </message>
    <message>
        <source>Labels…</source>
        <translation>Etiquetas…</translation>
    </message>
    <message>
        <source>Save the volume over time</source>
        <translation>Guardar el volumen en el tiempo</translation>
    </message>
    <message>
        <source>End-diastole %1 (frame %2), end-systole %3 (frame %4), stroke volume %5, &lt;b&gt;ejection fraction %6 %&lt;/b&gt;.</source>
        <translation>Telediástole %1 (fotograma %2), telesístole %3 (fotograma %4), volumen sistólico %5, &lt;b&gt;fracción de eyección %6 %&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>From frame %1 back at frame %2: Dice %3, %4 off.</source>
        <translation>Del %1 de vuelta en el %2: Dice %3, desvío de %4.</translation>
    </message>
    <message>
        <source>The surface was lost on its way from frame %1 back to frame %2.</source>
        <translation>La superficie se perdió en el camino del fotograma %1 de vuelta al fotograma %2.</translation>
    </message>
    <message>
        <source>Frame %1 is being corrected: change it with clicks, walls and edits, then carry on from there.</source>
        <translation>Se está corrigiendo el fotograma %1: cámbielo con puntos, barreras y ediciones, y luego propague desde allí.</translation>
    </message>
    <message>
        <source>Carrying the surface through the frames…</source>
        <translation>Propagando la superficie por los fotogramas…</translation>
    </message>
    <message>
        <source>These are of an earlier surface of frame %1: carry it anew.</source>
        <translation>Son de una superficie anterior del fotograma %1: propáguela de nuevo.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::RulersPage</name>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Delete the chosen ruler or angle</source>
        <translation>Eliminar la regla o el ángulo elegido</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Begins at (LPS)</source>
        <translation>Empieza en (LPS)</translation>
    </message>
    <message>
        <source>Rulers and angles</source>
        <translation>Reglas y ángulos</translation>
    </message>
    <message>
        <source>Places points in the slices or on the surface in 3D. Their ends can be dragged.</source>
        <translation>Pone puntos en los cortes o en la superficie en 3D. Sus extremos se pueden arrastrar.</translation>
    </message>
    <message>
        <source>Click where the ruler begins, or press Return for the crosshair.</source>
        <translation>Haga clic donde empieza la regla, o pulse Intro para la cruz.</translation>
    </message>
    <message>
        <source>Click where it ends. Escape takes the beginning back.</source>
        <translation>Haga clic donde termina. Escape retira el comienzo.</translation>
    </message>
    <message>
        <source>Click the end of one leg, or press Return for the crosshair.</source>
        <translation>Haga clic en el extremo de un lado, o pulse Intro para la cruz.</translation>
    </message>
    <message>
        <source>Click where the legs meet. Escape takes the last point back.</source>
        <translation>Haga clic donde se unen los lados. Escape retira el último punto.</translation>
    </message>
    <message>
        <source>Click the end of the other leg. Escape takes the last point back.</source>
        <translation>Haga clic en el extremo del otro lado. Escape retira el último punto.</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Guardar como CSV…</translation>
    </message>
    <message>
        <source>Lengths in mm, angles in degrees and their points (mm, LPS) as a table</source>
        <translation>Longitudes en mm, ángulos en grados y sus puntos (mm, LPS) como tabla</translation>
    </message>
    <message>
        <source>Save as JSON…</source>
        <translation>Guardar como JSON…</translation>
    </message>
    <message>
        <source>The same as “handlebody-cli measure --json” writes of them</source>
        <translation>Lo mismo que escribe de ellos «handlebody-cli measure --json»</translation>
    </message>
    <message>
        <source>Save the rulers and angles</source>
        <translation>Guardar las reglas y los ángulos</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SectionPlot</name>
    <message>
        <source>Area and equivalent diameter along the centre line</source>
        <translation>Área y diámetro equivalente a lo largo de la línea central</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Area (mm²)</source>
        <translation>Área (mm²)</translation>
    </message>
    <message>
        <source>Equivalent diameter (mm)</source>
        <translation>Diámetro equivalente (mm)</translation>
    </message>
    <message>
        <source>Area and equivalent diameter are plotted here along the line.</source>
        <translation>Aquí se trazan el área y el diámetro equivalente a lo largo de la línea.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SeedPanel</name>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Radius of the selected seed. Automatic: the largest ball that fits into the object; outside of it, as the image allows</source>
        <translation>Radio de la semilla elegida. Automático: la mayor bola que cabe en el objeto; fuera de él, lo que permita la imagen</translation>
    </message>
    <message>
        <source>%1 (auto)</source>
        <translation>%1 (auto)</translation>
    </message>
    <message>
        <source>None yet: it takes a seed inside.</source>
        <translation>Aún ninguno: hace falta una semilla dentro.</translation>
    </message>
    <message>
        <source>Given by the range in step 3, Tune.</source>
        <translation>Dado por el intervalo del paso 3, Ajustar.</translation>
    </message>
    <message>
        <source>Looking for it…</source>
        <translation>Buscando…</translation>
    </message>
    <message>
        <source>Click into the structure in any slice, then press Return: a ball is placed there, from which the surface grows. One seed is often enough. Shift+Return marks a place outside. Drag a seed to move it, its rim to resize it.</source>
        <translation>Haga clic en la estructura en cualquier corte y pulse Intro: allí se pone una bola, desde la que crece la superficie. A menudo basta una semilla. Mayús+Intro marca un lugar de fuera. Arrastre una semilla para moverla y su borde para cambiar su tamaño.</translation>
    </message>
    <message>
        <source>What is wrong with the seeds</source>
        <translation>Qué está mal en las semillas</translation>
    </message>
    <message>
        <source>Centre (mm LPS)</source>
        <translation>Centro (mm LPS)</translation>
    </message>
    <message>
        <source>Radius (mm)</source>
        <translation>Radio (mm)</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objeto</translation>
    </message>
    <message>
        <source>Seeds</source>
        <translation>Semillas</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>fuera</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>dentro</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SensitivityPage</name>
    <message>
        <source>Run</source>
        <translation>Ejecución</translation>
    </message>
    <message>
        <source>Volume (ml)</source>
        <translation>Volumen (ml)</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Componentes</translation>
    </message>
    <message>
        <source>Tunnels</source>
        <translation>Túneles</translation>
    </message>
    <message>
        <source>Away (mm)</source>
        <translation>Distancia (mm)</translation>
    </message>
    <message>
        <source>The perturbed runs</source>
        <translation>Las ejecuciones perturbadas</translation>
    </message>
    <message>
        <source>Save the perturbed runs</source>
        <translation>Guardar las ejecuciones perturbadas</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Sensibilidad</translation>
    </message>
    <message>
        <source>Grow the surface several times again, with clicks, smoothing and noise a little different: how much do volume and surface change?</source>
        <translation>Hacer crecer la superficie varias veces más, con puntos, suavizado y ruido algo distintos: ¿cuánto cambian el volumen y la superficie?</translation>
    </message>
    <message>
        <source> runs</source>
        <translation> ejecuciones</translation>
    </message>
    <message>
        <source>Number of runs</source>
        <translation>Número de ejecuciones</translation>
    </message>
    <message>
        <source>How often it is grown again; each takes about as long as the growth</source>
        <translation>Cuántas veces crece de nuevo; cada una tarda más o menos lo que el crecimiento</translation>
    </message>
    <message>
        <source>Volume with its spread</source>
        <translation>Volumen con su dispersión</translation>
    </message>
    <message>
        <source>State of the sensitivity</source>
        <translation>Estado de la sensibilidad</translation>
    </message>
    <message>
        <source>How far it moves, in colour on the surface</source>
        <translation>Cuánto se mueve, en color sobre la superficie</translation>
    </message>
    <message>
        <source>White where the surface is certain, red where it moves from run to run</source>
        <translation>Blanca donde la superficie es segura, roja donde se mueve de una ejecución a otra</translation>
    </message>
    <message>
        <source>How many runs have ended</source>
        <translation>Cuántas ejecuciones han terminado</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Guardar como CSV…</translation>
    </message>
    <message>
        <source>Save the runs as CSV</source>
        <translation>Guardar las ejecuciones como CSV</translation>
    </message>
    <message>
        <source>Volume, topology and distance of every run</source>
        <translation>Volumen, topología y distancia de cada ejecución</translation>
    </message>
    <message>
        <source>moves by</source>
        <translation>se mueve</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>%1 ± %2 ml</source>
        <translation>%1 ± %2 ml</translation>
    </message>
    <message>
        <source>%1 to %2 in %3 of %4 runs, %5 of the same topology. The surface moves by %6, 95 % of it by less than %7.</source>
        <translation>De %1 a %2 en %3 de %4 ejecuciones, %5 con la misma topología. La superficie se mueve %6, el 95 % de ella menos de %7.</translation>
    </message>
    <message>
        <source> ⚠ %1.</source>
        <translation> ⚠ %1.</translation>
    </message>
    <message>
        <source>None of the runs left a surface.</source>
        <translation>Ninguna de las ejecuciones dejó una superficie.</translation>
    </message>
    <message>
        <source>Growing it again…</source>
        <translation>Haciéndola crecer de nuevo…</translation>
    </message>
    <message>
        <source>These are figures of an earlier surface, or of another object.</source>
        <translation>Estas cifras son de una superficie anterior o de otro objeto.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SeriesList</name>
    <message>
        <source>, stack %1</source>
        <translation>, pila %1</translation>
    </message>
    <message>
        <source>No volume: %1</source>
        <translation>Sin volumen: %1</translation>
    </message>
    <message>
        <source>%1, %2 mm</source>
        <translation>%1, %2 mm</translation>
    </message>
    <message>
        <source>Slices: %1</source>
        <translation>Cortes: %1</translation>
    </message>
    <message>
        <source>Files: %1</source>
        <translation>Archivos: %1</translation>
    </message>
    <message>
        <source> · time points: %1</source>
        <translation> · instantes: %1</translation>
    </message>
    <message>
        <source>Series in the folder</source>
        <translation>Series de la carpeta</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SliceView</name>
    <message>
        <source>%1, oblique</source>
        <translation>%1, oblicuo</translation>
    </message>
    <message>
        <source>W %1  L %2</source>
        <translation>V %1  N %2</translation>
    </message>
    <message>
        <source>no edge in the image</source>
        <translation>sin borde en la imagen</translation>
    </message>
    <message>
        <source>pinned</source>
        <translation>fijado</translation>
    </message>
    <message>
        <source>Open a volume: Ctrl+O,
or drop a file here</source>
        <translation>Abrir un volumen: Ctrl+O,
o soltar aquí un archivo</translation>
    </message>
    <message>
        <source>%1 slice</source>
        <translation>Corte %1</translation>
    </message>
    <message>
        <source>Arrows and Page Up or Down move the crosshair, Return adds a seed, Shift and Return a click outside of the object, W changes window and level. B and E turn the brush for walls on and off, with Shift they paint and erase at the crosshair; L pins with it, Shift and L unpins, M smooths, U pulls.</source>
        <translation>Las flechas y Re Pág o Av Pág mueven la cruz, Intro añade una semilla, Mayús e Intro un punto exterior, W cambia ventana y nivel. B y E activan o no el pincel de barreras, con Mayús pintan y borran en la cruz; L fija, Mayús y L suelta, M suaviza, U estira.</translation>
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
        <translation>Distancia entre los centros de vóxeles vecinos</translation>
    </message>
    <message>
        <source>Size of a voxel</source>
        <translation>Tamaño de un vóxel</translation>
    </message>
    <message>
        <source>The file does not give it. Lengths and volumes are right only with the true spacing along columns, rows and slices.</source>
        <translation>El archivo no lo da. Las longitudes y los volúmenes solo son correctos con el espaciado real de columnas, filas y cortes.</translation>
    </message>
    <message>
        <source>Spacing of columns</source>
        <translation>Espaciado de columnas</translation>
    </message>
    <message>
        <source>Spacing of rows</source>
        <translation>Espaciado de filas</translation>
    </message>
    <message>
        <source>Spacing of slices</source>
        <translation>Espaciado de cortes</translation>
    </message>
    <message>
        <source>Open with this spacing</source>
        <translation>Abrir con este espaciado</translation>
    </message>
    <message>
        <source>File without a spacing</source>
        <translation>Archivo sin espaciado</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::StartPage</name>
    <message>
        <source>Open a volume to begin</source>
        <translation>Abra un volumen para empezar</translation>
    </message>
    <message>
        <source>Drop a CT, MR or ultrasound volume here, or choose one.</source>
        <translation>Suelte aquí un volumen de TC, RM o ecografía, o elija uno.</translation>
    </message>
    <message>
        <source>Try the ultrasound sample</source>
        <translation>Probar el ejemplo de ecografía</translation>
    </message>
    <message>
        <source>A simulated cyst with a needle through it, with its seed placed</source>
        <translation>Un quiste simulado atravesado por una aguja, con su semilla puesta</translation>
    </message>
    <message>
        <source>Opened before</source>
        <translation>Abiertos antes</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Abrir %1</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::StatusFields</name>
    <message>
        <source>Position of the mouse, mm LPS</source>
        <translation>Posición del ratón, mm LPS</translation>
    </message>
    <message>
        <source>Voxel under the mouse</source>
        <translation>Vóxel bajo el ratón</translation>
    </message>
    <message>
        <source>Voxel %1</source>
        <translation>Vóxel %1</translation>
    </message>
    <message>
        <source>Intensity of the voxel</source>
        <translation>Intensidad del vóxel</translation>
    </message>
    <message>
        <source>Intensity %1</source>
        <translation>Intensidad %1</translation>
    </message>
    <message>
        <source>Uncalibrated</source>
        <translation>Sin calibrar</translation>
    </message>
    <message>
        <source>State of the growth</source>
        <translation>Estado del crecimiento</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stop reading the volume; what is open stays open</source>
        <translation>Detener la lectura del volumen; lo abierto sigue abierto</translation>
    </message>
    <message>
        <source>The file does not give the size of a voxel: lengths, areas and volumes mean nothing until it is entered in step 1, Open</source>
        <translation>El archivo no da el tamaño de un vóxel: longitudes, áreas y volúmenes no significan nada hasta que se introduzca en el paso 1, Abrir</translation>
    </message>
    <message>
        <source>Nothing is open</source>
        <translation>No hay nada abierto</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>Leyendo %1…</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::StepsPanel</name>
    <message>
        <source>Step %1</source>
        <translation>Paso %1</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SurfaceView</name>
    <message>
        <source>This machine offers no OpenGL 3.2: the surface cannot be shown in 3D. Slices, growth and export work all the same.</source>
        <translation>Este equipo no ofrece OpenGL 3.2: la superficie no se puede mostrar en 3D. Cortes, crecimiento y exportación funcionan igualmente.</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>The surface grows here</source>
        <translation>La superficie crece aquí</translation>
    </message>
    <message>
        <source>Nothing is left of the surface</source>
        <translation>No queda nada de la superficie</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>Vista 3D</translation>
    </message>
    <message>
        <source>Home, End and Page Down look from superior, anterior and left. With the brush on, left pins, unpins, smooths or pulls the surface.</source>
        <translation>Inicio, Fin y Av Pág miran desde arriba, delante e izquierda. Con el pincel activo, el botón izquierdo fija, suelta, suaviza o estira la superficie.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TimeBar</name>
    <message>
        <source>Frame %1 of 0–%2</source>
        <translation>Fotograma %1 de 0–%2</translation>
    </message>
    <message>
        <source>%1, %2 ms</source>
        <translation>%1, %2 ms</translation>
    </message>
    <message>
        <source>Shown frame</source>
        <translation>Fotograma mostrado</translation>
    </message>
    <message>
        <source>What is wrong with the shown frame</source>
        <translation>Qué está mal en el fotograma mostrado</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Leyendo…</translation>
    </message>
    <message>
        <source>The surface is grown in this frame</source>
        <translation>La superficie crece en este fotograma</translation>
    </message>
    <message>
        <source>The surface has not been carried here</source>
        <translation>La superficie no se ha propagado aquí</translation>
    </message>
    <message>
        <source>The surface here was carried from an earlier state of frame %1: carry it again.</source>
        <translation>La superficie de aquí se propagó desde un estado anterior del fotograma %1: propáguela de nuevo.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TimelinePanel</name>
    <message>
        <source>Events</source>
        <translation>Eventos</translation>
    </message>
    <message>
        <source>Changes of topology are listed here.</source>
        <translation>Aquí se listan los cambios de topología.</translation>
    </message>
    <message>
        <source>Show repairs of the mesh, too</source>
        <translation>Mostrar también las reparaciones de la malla</translation>
    </message>
    <message>
        <source>&lt;p&gt;Folds that were smoothed away, and parts of the surface whose step would have left an invalid mesh and that returned to where they were. The topology is the same before and after.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Pliegues que se suavizaron, y partes de la superficie cuyo paso habría dejado una malla no válida y que volvieron a donde estaban. La topología es la misma antes y después.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TimelinePlot</name>
    <message>
        <source>Leak: %1</source>
        <translation>Fuga: %1</translation>
    </message>
    <message>
        <source>Volume and moving share over the iterations</source>
        <translation>Volumen y parte en movimiento a lo largo de las iteraciones</translation>
    </message>
    <message>
        <source>Iteration %1: %2, %3 % of the vertices moving, %4</source>
        <translation>Iteración %1: %2, %3 % de los vértices en movimiento, %4</translation>
    </message>
    <message>
        <source>events: %1</source>
        <translation>eventos: %1</translation>
    </message>
    <message>
        <source>Volume, up to %1</source>
        <translation>Volumen, hasta %1</translation>
    </message>
    <message>
        <source>Moving, 0 to 100 %</source>
        <translation>En movimiento, 0 a 100 %</translation>
    </message>
    <message>
        <source>Volume and motion are plotted here while the surface grows.</source>
        <translation>Aquí se trazan el volumen y el movimiento mientras crece la superficie.</translation>
    </message>
    <message>
        <source>Changed at %1: %2</source>
        <translation>Cambiado en %1: %2</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TimelineSlider</name>
    <message>
        <source>Iteration</source>
        <translation>Iteración</translation>
    </message>
    <message>
        <source>&lt;p&gt;Iterations; diamonds are changes of topology, strokes below the line places that were rolled back. Click or drag to go there.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Iteraciones; los rombos son cambios de topología, los trazos bajo la línea lugares que se revirtieron. Haga clic o arrastre para ir allí.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TopologySection</name>
    <message>
        <source>Held at iteration %1: %2.</source>
        <translation>Retenido en la iteración %1: %2.</translation>
    </message>
    <message>
        <source>any</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>Topology</source>
        <translation>Topología</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>Never more than</source>
        <translation>Nunca más de</translation>
    </message>
    <message>
        <source>Ask each time</source>
        <translation>Preguntar siempre</translation>
    </message>
    <message>
        <source>What happens where the surface would get more parts or tunnels than are chosen: it gets them, never does (what is held is listed in Correct), or the growth pauses and asks you</source>
        <translation>Qué ocurre donde la superficie tendría más partes o túneles de los elegidos: los tiene, nunca los tiene (lo retenido se lista en Corregir), o el crecimiento se pausa y le pregunta</translation>
    </message>
    <message>
        <source>Components at most</source>
        <translation>Componentes como máximo</translation>
    </message>
    <message>
        <source>Connected parts of the surface, cavities included</source>
        <translation>Partes conexas de la superficie, cavidades incluidas</translation>
    </message>
    <message>
        <source>Genus at most</source>
        <translation>Género como máximo</translation>
    </message>
    <message>
        <source>Tunnels, as in a ring, of all parts together</source>
        <translation>Túneles, como en un anillo, de todas las partes juntas</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Partes</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>Género</translation>
    </message>
    <message>
        <source>To decide</source>
        <translation>Por decidir</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>Dejar que ocurra</translation>
    </message>
    <message>
        <source>It may break the limits here; the growth goes on</source>
        <translation>Aquí puede superar los límites; el crecimiento sigue</translation>
    </message>
    <message>
        <source>Hold it</source>
        <translation>Retener</translation>
    </message>
    <message>
        <source>It stays held here, and you are not asked again; the growth goes on</source>
        <translation>Queda retenido aquí y no se le vuelve a preguntar; el crecimiento sigue</translation>
    </message>
    <message>
        <source>Free topology</source>
        <translation>Dejar libre la topología</translation>
    </message>
    <message>
        <source>Ask about the topology</source>
        <translation>Preguntar por la topología</translation>
    </message>
    <message>
        <source>Limit the topology</source>
        <translation>Limitar la topología</translation>
    </message>
    <message>
        <source>%1 more to decide.</source>
        <translation>%1 más por decidir.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TouchSection</name>
    <message>
        <source>Pin</source>
        <translation>Fijar</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>Soltar</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Suavizar</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Estirar</translation>
    </message>
    <message>
        <source>Cut line</source>
        <translation>Cortar línea</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>Number of pins</source>
        <translation>Número de fijaciones</translation>
    </message>
    <message>
        <source>Nothing is pinned.</source>
        <translation>No hay nada fijado.</translation>
    </message>
    <message>
        <source>Balls pinned: %1</source>
        <translation>Bolas fijadas: %1</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TunePanel</name>
    <message>
        <source>What is wrong with the parameters</source>
        <translation>Qué está mal en los parámetros</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objeto</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>Bright</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>The object is darker than its surroundings</source>
        <translation>El objeto es más oscuro que su entorno</translation>
    </message>
    <message>
        <source>The object is brighter than its surroundings</source>
        <translation>El objeto es más claro que su entorno</translation>
    </message>
    <message>
        <source>Found out from the image around the seeds</source>
        <translation>Averiguado de la imagen alrededor de las semillas</translation>
    </message>
    <message>
        <source>Change object</source>
        <translation>Cambiar objeto</translation>
    </message>
    <message>
        <source>Intensities from the lower to the upper end belong to the object</source>
        <translation>Las intensidades del extremo inferior al superior pertenecen al objeto</translation>
    </message>
    <message>
        <source>Intensities of the object</source>
        <translation>Intensidades del objeto</translation>
    </message>
    <message>
        <source>Lowest intensity of the object</source>
        <translation>Intensidad más baja del objeto</translation>
    </message>
    <message>
        <source>Highest intensity of the object</source>
        <translation>Intensidad más alta del objeto</translation>
    </message>
    <message>
        <source>Range: automatic</source>
        <translation>Intervalo: automático</translation>
    </message>
    <message>
        <source>Chosen from the image around the seeds</source>
        <translation>Elegido de la imagen alrededor de las semillas</translation>
    </message>
    <message>
        <source>to</source>
        <translation>a</translation>
    </message>
    <message>
        <source>Change range</source>
        <translation>Cambiar intervalo</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>Change smoothing</source>
        <translation>Cambiar suavizado</translation>
    </message>
    <message>
        <source>Change edge length</source>
        <translation>Cambiar longitud de arista</translation>
    </message>
    <message>
        <source>Change balloon</source>
        <translation>Cambiar globo</translation>
    </message>
    <message>
        <source>Change curvature</source>
        <translation>Cambiar curvatura</translation>
    </message>
    <message>
        <source>Change iteration limit</source>
        <translation>Cambiar límite de iteraciones</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Outward</source>
        <translation>Expansión</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Ambos</translation>
    </message>
    <message>
        <source>The surface only grows</source>
        <translation>La superficie solo crece</translation>
    </message>
    <message>
        <source>The surface may also shrink</source>
        <translation>La superficie también puede encogerse</translation>
    </message>
    <message>
        <source>Change direction</source>
        <translation>Cambiar dirección</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Experto</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>Colisiones</translation>
    </message>
    <message>
        <source>Sorted</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>Hashing</source>
        <translation>Hash</translation>
    </message>
    <message>
        <source>Near vertices are found in one sorted table. The surface does not depend on it</source>
        <translation>Los vértices cercanos se hallan en una tabla ordenada. La superficie no depende de ello</translation>
    </message>
    <message>
        <source>Near vertices are found by the paper's eight hash functions: slower, the same surface</source>
        <translation>Los vértices cercanos se hallan con las ocho funciones hash del artículo: más lento, la misma superficie</translation>
    </message>
    <message>
        <source>Change search for collisions</source>
        <translation>Cambiar búsqueda de colisiones</translation>
    </message>
    <message>
        <source>%1 everything here is then chosen from the image. Change it only if the surface leaks or stops early.</source>
        <translation>%1 todo esto se elige entonces de la imagen. Cámbielo solo si la superficie se fuga o se detiene pronto.</translation>
    </message>
    <message>
        <source>Place a seed:</source>
        <translation>Ponga una semilla:</translation>
    </message>
    <message>
        <source>Open a volume and place a seed:</source>
        <translation>Abra un volumen y ponga una semilla:</translation>
    </message>
    <message>
        <source>Auto (dark)</source>
        <translation>Auto (oscuro)</translation>
    </message>
    <message>
        <source>Auto (bright)</source>
        <translation>Auto (claro)</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Aristas</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>Uniformes</translation>
    </message>
    <message>
        <source>Adaptive</source>
        <translation>Adaptativas</translation>
    </message>
    <message>
        <source>The target edge length is the same everywhere</source>
        <translation>La longitud de arista buscada es la misma en todas partes</translation>
    </message>
    <message>
        <source>Edges and steps are up to four times as long where the image shows no boundary near by: fewer iterations</source>
        <translation>Las aristas y los pasos son hasta cuatro veces más largos donde la imagen no muestra ningún borde cerca: menos iteraciones</translation>
    </message>
    <message>
        <source>Change edges</source>
        <translation>Cambiar aristas</translation>
    </message>
    <message>
        <source>Tint the object in the slices</source>
        <translation>Teñir el objeto en los cortes</translation>
    </message>
    <message>
        <source>The voxels that the surface is driven into: as smoothed, up to necks that are cut and to walls. They are tinted for a moment after every change; with this on, all the time</source>
        <translation>Los vóxeles hacia los que avanza la superficie: suavizados, hasta los cuellos cortados y las paredes. Se tiñen un momento tras cada cambio; marcado, siempre</translation>
    </message>
    <message>
        <source>Adaptive where the object is wide for its edges, so that this saves iterations</source>
        <translation>Adaptativa donde el objeto es lo bastante ancho para sus aristas como para ahorrar iteraciones</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TunnelsList</name>
    <message>
        <source>Component removed</source>
        <translation>Componente quitado</translation>
    </message>
    <message>
        <source>One component kept</source>
        <translation>Un componente conservado</translation>
    </message>
    <message>
        <source>Cavity filled</source>
        <translation>Cavidad rellenada</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>Suavizado</translation>
    </message>
    <message>
        <source>Pulled</source>
        <translation>Estirado</translation>
    </message>
    <message>
        <source>Cut by a plane</source>
        <translation>Cortado por un plano</translation>
    </message>
    <message>
        <source>Handle cut</source>
        <translation>Asa cortada</translation>
    </message>
    <message>
        <source>Tunnel filled</source>
        <translation>Túnel rellenado</translation>
    </message>
    <message>
        <source>Tunnel closed</source>
        <translation>Túnel cerrado</translation>
    </message>
    <message>
        <source>What the surface holds</source>
        <translation>Lo que contiene la superficie</translation>
    </message>
    <message>
        <source>The chosen row</source>
        <translation>La fila elegida</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Tunnels, components and cavities, each with its size</source>
        <translation>Túneles, componentes y cavidades, con su tamaño</translation>
    </message>
    <message>
        <source>Cut handle</source>
        <translation>Cortar asa</translation>
    </message>
    <message>
        <source>Cuts along the loop around the handle, which goes; both ends get a cap</source>
        <translation>Corta por el lazo alrededor del asa, que desaparece; ambos extremos reciben una tapa</translation>
    </message>
    <message>
        <source>Fill tunnel</source>
        <translation>Rellenar túnel</translation>
    </message>
    <message>
        <source>Cuts along the loop round the tunnel: a membrane closes it on both sides</source>
        <translation>Corta por el lazo alrededor del túnel: una membrana lo cierra por ambos lados</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Removes this component with all that lies in it</source>
        <translation>Quita este componente con todo lo que contiene</translation>
    </message>
    <message>
        <source>Keep only this</source>
        <translation>Conservar solo esto</translation>
    </message>
    <message>
        <source>Removes everything but this component and its cavities</source>
        <translation>Quita todo menos este componente y sus cavidades</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Rellenar</translation>
    </message>
    <message>
        <source>Fills this cavity, with all that lies in it</source>
        <translation>Rellena esta cavidad, con todo lo que contiene</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Omitir</translation>
    </message>
    <message>
        <source>Goes back to the step before this edit, and on without it</source>
        <translation>Vuelve al paso anterior a esta edición y sigue sin ella</translation>
    </message>
    <message>
        <source>Tunnel</source>
        <translation>Túnel</translation>
    </message>
    <message>
        <source>%1 around its handle, %2 round the tunnel</source>
        <translation>%1 alrededor del asa, %2 alrededor del túnel</translation>
    </message>
    <message>
        <source>; knotted</source>
        <translation>; anudado</translation>
    </message>
    <message>
        <source>Cavity</source>
        <translation>Cavidad</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>Componente</translation>
    </message>
    <message>
        <source>%1 mm, genus %2</source>
        <translation>%1 mm, género %2</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>paso %1</translation>
    </message>
    <message>
        <source>At %1</source>
        <translation>En %1</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>Buscando…</translation>
    </message>
    <message>
        <source>Tunnels: %1</source>
        <translation>Túneles: %1</translation>
    </message>
    <message>
        <source>components: %1</source>
        <translation>componentes: %1</translation>
    </message>
    <message>
        <source>cavities: %1</source>
        <translation>cavidades: %1</translation>
    </message>
    <message>
        <source>tunnels without loops: %1</source>
        <translation>túneles sin lazos: %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Find tunnels and pieces</source>
        <translation>Buscar túneles y piezas</translation>
    </message>
    <message>
        <source>Lists the tunnels, components and cavities of the shown surface</source>
        <translation>Lista los túneles, componentes y cavidades de la superficie mostrada</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ValueField</name>
    <message>
        <source>Reset %1</source>
        <translation>Restablecer %1</translation>
    </message>
    <message>
        <source>Back to the usual value, %1</source>
        <translation>Volver al valor habitual, %1</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>%1: automatic</source>
        <translation>%1: automático</translation>
    </message>
    <message>
        <source>The value is chosen from the image around the seeds</source>
        <translation>El valor se elige de la imagen alrededor de las semillas</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ViewFrame</name>
    <message>
        <source>Show all four views (double click)</source>
        <translation>Mostrar las cuatro vistas (doble clic)</translation>
    </message>
    <message>
        <source>Let this view fill the window (double click)</source>
        <translation>Esta vista llena la ventana (doble clic)</translation>
    </message>
    <message>
        <source>Show all four views</source>
        <translation>Mostrar las cuatro vistas</translation>
    </message>
    <message>
        <source>Maximise the %1 view</source>
        <translation>Maximizar la vista %1</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ViewGrid</name>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagital</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>%1 view</source>
        <translation>Vista %1</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::VolumePlot</name>
    <message>
        <source>Volume over time</source>
        <translation>Volumen en el tiempo</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Volume (ml) over time (ms)</source>
        <translation>Volumen (ml) en el tiempo (ms)</translation>
    </message>
    <message>
        <source>Volume (ml) over frames</source>
        <translation>Volumen (ml) por fotograma</translation>
    </message>
    <message>
        <source>end-diastole</source>
        <translation>telediástole</translation>
    </message>
    <message>
        <source>end-systole</source>
        <translation>telesístole</translation>
    </message>
    <message>
        <source>The volume over time is plotted here when the surface is carried through the frames.</source>
        <translation>El volumen en el tiempo se traza aquí cuando la superficie se propaga por los fotogramas.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::WallSection</name>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>Number of walls</source>
        <translation>Número de barreras</translation>
    </message>
    <message>
        <source>Nothing is painted.</source>
        <translation>No hay nada pintado.</translation>
    </message>
    <message>
        <source>Balls painted: %1</source>
        <translation>Bolas pintadas: %1</translation>
    </message>
</context>
</TS>
