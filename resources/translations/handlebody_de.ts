<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Findings</name>
    <message>
        <source>the surface is held at a neck of radius {radius_mm:3g} mm: behind it the same intensities go on for at least {behind_ml:3g} ml, in front of it they fill {in_front_ml:3g} ml; where that belongs to the object, put a seed there too, or set the range in step 3, Tune, which holds nothing back</source>
        <translation>die Oberfläche wird an einer Engstelle von {radius_mm:3g} mm Radius gehalten: dahinter setzen sich dieselben Intensitäten über mindestens {behind_ml:3g} ml fort, davor füllen sie {in_front_ml:3g} ml; wenn das zum Objekt gehört, setzen Sie auch dort einen Startpunkt oder geben Sie den Bereich in Schritt 3, Anpassen, vor, der nichts zurückhält</translation>
    </message>
    <message>
        <source>the surface is held at a hole of radius {radius_mm:3g} mm in a thin wall: behind it the same intensities go on for at least {behind_ml:3g} ml, in front of it they fill {in_front_ml:3g} ml; where that belongs to the object, put a seed there too, or set the range in step 3, Tune, which holds nothing back</source>
        <translation>die Oberfläche wird an einem Loch von {radius_mm:3g} mm Radius in einer dünnen Wand gehalten: dahinter setzen sich dieselben Intensitäten über mindestens {behind_ml:3g} ml fort, davor füllen sie {in_front_ml:3g} ml; wenn das zum Objekt gehört, setzen Sie auch dort einen Startpunkt oder geben Sie den Bereich in Schritt 3, Anpassen, vor, der nichts zurückhält</translation>
    </message>
    <message>
        <source>the surface is held where its structure grows wider than a radius of {radius_mm:3g} mm: behind it the same intensities go on for at least {behind_ml:3g} ml, in front of it they fill {in_front_ml:3g} ml; where that belongs to the object, put a seed there too, or set the range in step 3, Tune, which holds nothing back</source>
        <translation>die Oberfläche wird dort gehalten, wo ihre Struktur über einen Radius von {radius_mm:3g} mm hinaus weiter wird: dahinter setzen sich dieselben Intensitäten über mindestens {behind_ml:3g} ml fort, davor füllen sie {in_front_ml:3g} ml; wenn das zum Objekt gehört, setzen Sie auch dort einen Startpunkt oder geben Sie den Bereich in Schritt 3, Anpassen, vor, der nichts zurückhält</translation>
    </message>
    <message>
        <source>the surface got stuck: no part of a step could be kept, again and again; another edge length may help</source>
        <translation>die Oberfläche steckt fest: immer wieder konnte kein Teil eines Schritts beibehalten werden; eine andere Kantenlänge kann helfen</translation>
    </message>
    <message>
        <source>the surface rests at places that would still move, because changes there failed or repeated again and again; another edge length or smoothing may help</source>
        <translation>die Oberfläche ruht an Stellen, die sich noch bewegen würden, weil Änderungen dort immer wieder fehlschlugen oder sich wiederholten; eine andere Kantenlänge oder Glättung kann helfen</translation>
    </message>
    <message>
        <source>the surface hardly grew beyond its seed: look at the kind of object and the range in step 3, Tune</source>
        <translation>die Oberfläche ist kaum über ihren Startpunkt hinausgewachsen: prüfen Sie die Art des Objekts und den Bereich in Schritt 3, Anpassen</translation>
    </message>
    <message>
        <source>the surface hardly grew beyond its seed: the curvature weight holds every front of a radius below {radius_mm:3g} mm, and the seed is smaller; give it a larger radius, or lower the weight</source>
        <translation>die Oberfläche ist kaum über ihren Startpunkt hinausgewachsen: das Krümmungsgewicht hält jede Front mit einem Radius unter {radius_mm:3g} mm, und der Startpunkt ist kleiner; geben Sie ihm einen größeren Radius oder senken Sie das Gewicht</translation>
    </message>
    <message>
        <source>the choice among {objects} objects is close (expected overlap with the one that is meant: Dice {dice:2g}): the next candidate holds {next_ml:3m} ml where this one holds {this_ml:3m} ml; another one can be chosen in step 2, Seed</source>
        <translation>die Wahl unter {objects} Objekten ist knapp (erwartete Überlappung mit dem gemeinten: Dice {dice:2g}): der nächste Kandidat fasst {next_ml:3m} ml, dieser {this_ml:3m} ml; ein anderer lässt sich in Schritt 2, Punkte, wählen</translation>
    </message>
    <message>
        <source>the surface leaked at iteration {iteration}: {cause}</source>
        <translation>die Oberfläche ist bei Iteration {iteration} ausgelaufen: {cause}</translation>
    </message>
    <message>
        <source>the surface leaked at iteration {iteration}: {cause}; a wall was put there</source>
        <translation>die Oberfläche ist bei Iteration {iteration} ausgelaufen: {cause}; dort wurde eine Wand gesetzt</translation>
    </message>
    <message>
        <source>the surface leaked at iteration {iteration}: {cause}; the mesh is that of iteration {mesh_iteration}, before it came there</source>
        <translation>die Oberfläche ist bei Iteration {iteration} ausgelaufen: {cause}; das Netz ist das von Iteration {mesh_iteration}, bevor sie dorthin kam</translation>
    </message>
    <message>
        <source>The seed is not in an object with a boundary of its own: what grows from it fills the field of view, up to the padding around the image. Where that is meant, say whether it is dark or bright, or set the range in step 3, Tune.</source>
        <translation>Der Startpunkt liegt nicht in einem Objekt mit eigenem Rand: was von ihm aus wächst, füllt das Bildfeld bis zum Füllbereich um das Bild. Ist das gemeint, wählen Sie dunkel oder hell oder geben Sie den Bereich in Schritt 3, Anpassen, vor.</translation>
    </message>
    <message>
        <source>The seed at {place:1f} mm lies outside the volume.</source>
        <translation>Der Startpunkt bei {place:1f} mm liegt außerhalb des Bildvolumens.</translation>
    </message>
    <message>
        <source>The click outside of the object at {place:1f} mm lies outside the volume.</source>
        <translation>Der Außenpunkt bei {place:1f} mm liegt außerhalb des Bildvolumens.</translation>
    </message>
    <message>
        <source>The seed at {place:1f} mm is not in the object: the smoothed intensity there is {intensity:4g}, the object's range is {low:4g} to {high:4g}.</source>
        <translation>Der Startpunkt bei {place:1f} mm liegt nicht im Objekt: die geglättete Intensität ist dort {intensity:4g}, der Bereich des Objekts reicht von {low:4g} bis {high:4g}.</translation>
    </message>
    <message>
        <source>The range {low:4g} to {high:4g} holds no voxel of the volume, whose values run from {least:4g} to {most:4g}.</source>
        <translation>Im Bereich {low:4g} bis {high:4g} liegt kein Voxel des Bildvolumens, dessen Werte von {least:4g} bis {most:4g} reichen.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>{percent:0f} % of the surface lies where the image shows no edge: the object may go on there, or the surface leaked</source>
        <translation>{percent:0f} % der Oberfläche liegen dort, wo das Bild keine Kante zeigt: das Objekt setzt sich dort womöglich fort, oder die Oberfläche ist ausgelaufen</translation>
    </message>
    <message>
        <source>{percent:0f} % of the surface lies on the border of the volume: the object is cut off there, or the surface leaked</source>
        <translation>{percent:0f} % der Oberfläche liegen auf dem Rand des Bildvolumens: das Objekt ist dort abgeschnitten, oder die Oberfläche ist ausgelaufen</translation>
    </message>
    <message>
        <source>{percent:0f} % of the surface lies on the border of the field of view: the object is cut off there, or the surface leaked</source>
        <translation>{percent:0f} % der Oberfläche liegen auf dem Rand des Bildfelds: das Objekt ist dort abgeschnitten, oder die Oberfläche ist ausgelaufen</translation>
    </message>
    <message>
        <source>the surface still lies in a wall that was put over it</source>
        <translation>die Oberfläche liegt noch in einer Wand, die über sie gelegt wurde</translation>
    </message>
    <message>
        <source>at the allowed place {place} nothing came that a limit of the topology would have held</source>
        <translation>an der erlaubten Stelle {place} kam nichts, was eine Grenze der Topologie gehalten hätte</translation>
    </message>
    <message>
        <source>the surface is held at passages narrower than a radius of {radius_mm:3g} mm; where what lies behind them belongs to the object, put a seed there too, or take a larger candidate</source>
        <translation>die Oberfläche wird an Durchgängen gehalten, die enger sind als {radius_mm:3g} mm Radius; wenn das, was dahinter liegt, zum Objekt gehört, setzen Sie auch dort einen Startpunkt oder nehmen Sie einen größeren Kandidaten</translation>
    </message>
    <message>
        <source>the object reaches the end of what was searched around the seed and is cut off there; where it goes on, put a seed there too</source>
        <translation>das Objekt reicht bis ans Ende dessen, was um den Startpunkt herum abgesucht wurde, und ist dort abgeschnitten; wo es weitergeht, setzen Sie auch dort einen Startpunkt</translation>
    </message>
    <message>
        <source>it came through a passage {width_mm:1f} mm wide at {place:1f} from a space {before_mm:0f} mm wide into one {behind_mm:0f} mm wide</source>
        <translation>sie kam durch einen {width_mm:1f} mm weiten Durchgang bei {place:1f} aus einem {before_mm:0f} mm weiten Raum in einen {behind_mm:0f} mm weiten</translation>
    </message>
    <message>
        <source>it came through a passage too narrow for the voxels to show at {place:1f} from a space {before_mm:0f} mm wide into one {behind_mm:0f} mm wide</source>
        <translation>sie kam bei {place:1f} durch einen Durchgang, der enger ist, als die Voxel zeigen können, aus einem {before_mm:0f} mm weiten Raum in einen {behind_mm:0f} mm weiten</translation>
    </message>
    <message>
        <source>the pin {pin} holds nothing: the mesh is that of iteration {mesh_iteration}, and its iteration never came</source>
        <translation>die Fixierung {pin} hält nichts: das Netz ist das von Iteration {mesh_iteration}, und ihre Iteration kam nie</translation>
    </message>
    <message>
        <source>With clicks, smoothing and noise a little different, {runs} of {of} runs leave no surface</source>
        <translation>Mit etwas anderen Punkten, anderer Glättung und anderem Rauschen lassen {runs} von {of} Läufen keine Oberfläche übrig</translation>
    </message>
    <message>
        <source>With clicks, smoothing and noise a little different, {runs} of {of} runs have another topology</source>
        <translation>Mit etwas anderen Punkten, anderer Glättung und anderem Rauschen haben {runs} von {of} Läufen eine andere Topologie</translation>
    </message>
    <message>
        <source>The volume depends on where exactly is clicked, on smoothing or noise: it changes by {percent:0f} %</source>
        <translation>Das Volumen hängt davon ab, wo genau geklickt wird, von Glättung oder Rauschen: es ändert sich um {percent:0f} %</translation>
    </message>
    <message>
        <source>The surface was made with an earlier one of the object '{object}', and a replay may make another</source>
        <translation>Die Oberfläche wurde mit einer früheren des Objekts „{object}“ gemacht, und eine Wiederholung ergibt womöglich eine andere</translation>
    </message>
    <message>
        <source>kept apart here, as asked</source>
        <translation>hier wie gewünscht getrennt gehalten</translation>
    </message>
    <message>
        <source>held: it would break the limit of the topology</source>
        <translation>gehalten: es würde die Grenze der Topologie überschreiten</translation>
    </message>
    <message>
        <source>the same place changed again and again, and rests from now on</source>
        <translation>dieselbe Stelle änderte sich immer wieder und ruht von nun an</translation>
    </message>
    <message>
        <source>no part of the step could be kept</source>
        <translation>kein Teil des Schritts konnte beibehalten werden</translation>
    </message>
    <message>
        <source>{fronts} fronts could not be joined at once: {cause}</source>
        <translation>{fronts} Fronten konnten nicht auf einmal verbunden werden: {cause}</translation>
    </message>
    <message>
        <source>of {fronts} fronts {left} left for the next round</source>
        <translation>von {fronts} Fronten bleiben {left} für die nächste Runde</translation>
    </message>
    <message>
        <source>1 ring added: {cause}</source>
        <translation>1 Ring dazu: {cause}</translation>
    </message>
    <message>
        <source>{rings} rings added: {cause}</source>
        <translation>{rings} Ringe dazu: {cause}</translation>
    </message>
    <message>
        <source>there may be a shorter handle</source>
        <translation>es gibt womöglich einen kürzeren Henkel</translation>
    </message>
    <message>
        <source>the surface came to a pinned part, and stops before it</source>
        <translation>die Oberfläche kam an einen fixierten Teil und hält davor</translation>
    </message>
    <message>
        <source>to close the place would take too much work</source>
        <translation>die Stelle zu schließen wäre zu aufwendig</translation>
    </message>
    <message>
        <source>the work that a step may take is done: the place waits</source>
        <translation>die Arbeit, die ein Schritt leisten darf, ist getan: die Stelle wartet</translation>
    </message>
    <message>
        <source>the fronts meet through the inside of the object</source>
        <translation>die Fronten treffen sich durch das Innere des Objekts</translation>
    </message>
    <message>
        <source>no handle fits</source>
        <translation>kein Henkel passt</translation>
    </message>
    <message>
        <source>no patch fits</source>
        <translation>kein Flicken passt</translation>
    </message>
    <message>
        <source>the component encloses a place where no surface may go</source>
        <translation>die Komponente umschließt eine Stelle, an die keine Oberfläche darf</translation>
    </message>
    <message>
        <source>the opening is too large</source>
        <translation>die Öffnung ist zu groß</translation>
    </message>
    <message>
        <source>a pinned part lies there</source>
        <translation>dort liegt ein fixierter Teil</translation>
    </message>
    <message>
        <source>nothing of the component would be left</source>
        <translation>von der Komponente bliebe nichts übrig</translation>
    </message>
    <message>
        <source>the surface would have entered a wall</source>
        <translation>die Oberfläche wäre in eine Wand geraten</translation>
    </message>
    <message>
        <source>a part of the surface has changed that detection had not looked at</source>
        <translation>ein Teil der Oberfläche hat sich geändert, den die Erkennung nicht betrachtet hat</translation>
    </message>
    <message>
        <source>the events of the step do not follow from each other</source>
        <translation>die Ereignisse des Schritts folgen nicht auseinander</translation>
    </message>
    <message>
        <source>the Euler number is not the one that the events predict</source>
        <translation>die Euler-Zahl ist nicht die, die aus den Ereignissen folgt</translation>
    </message>
    <message>
        <source>the components are not those that the events predict</source>
        <translation>die Komponenten sind nicht die, die aus den Ereignissen folgen</translation>
    </message>
    <message>
        <source>a cavity lies outside of any body</source>
        <translation>ein Hohlraum liegt außerhalb jedes Körpers</translation>
    </message>
    <message>
        <source>a body lies directly in another</source>
        <translation>ein Körper liegt unmittelbar in einem anderen</translation>
    </message>
    <message>
        <source>the surface still intersected itself after several changes</source>
        <translation>die Oberfläche schnitt sich nach mehreren Änderungen noch immer selbst</translation>
    </message>
    <message>
        <source>the surface does not enclose a volume</source>
        <translation>die Oberfläche umschließt kein Volumen</translation>
    </message>
    <message>
        <source>the surface would close over a pinned part, and stops before it</source>
        <translation>die Oberfläche würde sich über einem fixierten Teil schließen und hält davor</translation>
    </message>
    <message>
        <source>a pinned part would have changed</source>
        <translation>ein fixierter Teil hätte sich geändert</translation>
    </message>
    <message>
        <source>the surface would come into a wall or around it</source>
        <translation>die Oberfläche geriete in eine Wand oder um sie herum</translation>
    </message>
    <message>
        <source>a pinned part would change</source>
        <translation>ein fixierter Teil würde sich ändern</translation>
    </message>
    <message>
        <source>there would be more components than may be</source>
        <translation>es gäbe mehr Komponenten als erlaubt</translation>
    </message>
    <message>
        <source>there would be more tunnels than may be</source>
        <translation>es gäbe mehr Tunnel als erlaubt</translation>
    </message>
    <message>
        <source>an edge has only one face</source>
        <translation>eine Kante hat nur eine Fläche</translation>
    </message>
    <message>
        <source>two faces disagree about their common edge</source>
        <translation>zwei Flächen sind sich über ihre gemeinsame Kante uneins</translation>
    </message>
    <message>
        <source>the two faces of an edge run in the same direction or have other ends</source>
        <translation>die beiden Flächen einer Kante laufen in dieselbe Richtung oder haben andere Enden</translation>
    </message>
    <message>
        <source>two faces have the same three vertices</source>
        <translation>zwei Flächen haben dieselben drei Ecken</translation>
    </message>
    <message>
        <source>a face has a vertex that was removed</source>
        <translation>eine Fläche hat eine Ecke, die entfernt wurde</translation>
    </message>
    <message>
        <source>a face has a vertex twice</source>
        <translation>eine Fläche hat eine Ecke doppelt</translation>
    </message>
    <message>
        <source>a vertex has no face</source>
        <translation>eine Ecke hat keine Fläche</translation>
    </message>
    <message>
        <source>a vertex names a half-edge that does not leave it</source>
        <translation>eine Ecke nennt eine Halbkante, die nicht von ihr ausgeht</translation>
    </message>
    <message>
        <source>two edges join the same two vertices</source>
        <translation>zwei Kanten verbinden dieselben zwei Ecken</translation>
    </message>
    <message>
        <source>the faces around a vertex form more than one fan</source>
        <translation>die Flächen um eine Ecke bilden mehr als einen Fächer</translation>
    </message>
    <message>
        <source>the counts of the mesh are not those of its elements</source>
        <translation>die Anzahlen des Netzes sind nicht die seiner Elemente</translation>
    </message>
    <message>
        <source>no vertex of the surface lies in the ball</source>
        <translation>keine Ecke der Oberfläche liegt in der Kugel</translation>
    </message>
    <message>
        <source>the plane does not meet the surface</source>
        <translation>die Ebene trifft die Oberfläche nicht</translation>
    </message>
    <message>
        <source>the plane does not meet the surface near that place</source>
        <translation>die Ebene trifft die Oberfläche nicht in der Nähe dieser Stelle</translation>
    </message>
    <message>
        <source>no flat cap fits the cut</source>
        <translation>kein ebener Deckel passt auf den Schnitt</translation>
    </message>
    <message>
        <source>the cut does not part the body there: both of its sides hang together</source>
        <translation>der Schnitt teilt den Körper dort nicht: seine beiden Seiten hängen zusammen</translation>
    </message>
    <message>
        <source>the pull goes too far for its radius</source>
        <translation>der Zug geht für seinen Radius zu weit</translation>
    </message>
    <message>
        <source>nothing of the surface would be left</source>
        <translation>von der Oberfläche bliebe nichts übrig</translation>
    </message>
    <message>
        <source>the surface would meet itself there</source>
        <translation>die Oberfläche würde dort auf sich selbst treffen</translation>
    </message>
    <message>
        <source>No seed was given: at least one is needed.</source>
        <translation>Es wurde kein Startpunkt gegeben: mindestens einer wird gebraucht.</translation>
    </message>
    <message>
        <source>The radius of a seed must be a number of mm above 0.</source>
        <translation>Der Radius eines Startpunkts muss eine Zahl von mm über 0 sein.</translation>
    </message>
    <message>
        <source>The seed is not in a dark object: the image has no clear boundary of that kind around it.</source>
        <translation>Der Startpunkt liegt nicht in einem dunklen Objekt: das Bild hat um ihn keinen klaren Rand dieser Art.</translation>
    </message>
    <message>
        <source>The seed is not in a bright object: the image has no clear boundary of that kind around it.</source>
        <translation>Der Startpunkt liegt nicht in einem hellen Objekt: das Bild hat um ihn keinen klaren Rand dieser Art.</translation>
    </message>
    <message>
        <source>The seed is not in a dark or bright object: the image has no clear boundary of that kind around it.</source>
        <translation>Der Startpunkt liegt nicht in einem dunklen oder hellen Objekt: das Bild hat um ihn keinen klaren Rand dieser Art.</translation>
    </message>
    <message>
        <source>The range is empty: its lower end is above its upper end.</source>
        <translation>Der Bereich ist leer: sein unteres Ende liegt über dem oberen.</translation>
    </message>
    <message>
        <source>Clicks outside of the object and a given range do not go together: the range alone says where the object ends.</source>
        <translation>Außenpunkte und ein vorgegebener Bereich gehen nicht zusammen: der Bereich allein sagt, wo das Objekt endet.</translation>
    </message>
    <message>
        <source>The edge length of {edge_mm} mm is too short for the seeds: their surface alone would have over two million triangles.</source>
        <translation>Die Kantenlänge von {edge_mm} mm ist zu kurz für die Startpunkte: ihre Oberfläche allein hätte über zwei Millionen Dreiecke.</translation>
    </message>
    <message>
        <source>The seed at {place} mm lies in the object '{object}', which is done already.</source>
        <translation>Der Startpunkt bei {place} mm liegt im Objekt „{object}“, das schon fertig ist.</translation>
    </message>
    <message>
        <source>A wall lies over the seed at {place} mm.</source>
        <translation>Über dem Startpunkt bei {place} mm liegt eine Wand.</translation>
    </message>
    <message>
        <source>A wall leaves the seed at {place} mm no room.</source>
        <translation>Eine Wand lässt dem Startpunkt bei {place} mm keinen Platz.</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies within the surface, which cannot be pushed out of it: go back to before it came in there.</source>
        <translation>Die Wand bei {place} mm liegt innerhalb der Oberfläche, die nicht aus ihr herausgeschoben werden kann: gehen Sie zurück vor die Stelle, an der sie dorthin kam.</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies across surface that is already there: go back to before it came in there.</source>
        <translation>Die Wand bei {place} mm liegt quer durch Oberfläche, die schon da ist: gehen Sie zurück vor die Stelle, an der sie dorthin kam.</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies over surface that is already there: go back to before it came in there, or let the surface move in both directions.</source>
        <translation>Die Wand bei {place} mm liegt über Oberfläche, die schon da ist: gehen Sie zurück vor die Stelle, an der sie dorthin kam, oder lassen Sie die Oberfläche sich in beide Richtungen bewegen.</translation>
    </message>
    <message>
        <source>The object '{object}' lies over surface that is already there: go back to before it came in there.</source>
        <translation>Das Objekt „{object}“ liegt über Oberfläche, die schon da ist: gehen Sie zurück vor die Stelle, an der sie dorthin kam.</translation>
    </message>
    <message>
        <source>The clicks have so little in common with the surface that it would begin anew, but a part of it is pinned: take the pins away first.</source>
        <translation>Die Punkte haben so wenig mit der Oberfläche gemein, dass sie neu begänne, aber ein Teil von ihr ist fixiert: nehmen Sie zuerst die Fixierungen weg.</translation>
    </message>
    <message>
        <source>The veto of iteration {iteration} comes too late: the surface is at iteration {now}.</source>
        <translation>Das Veto für Iteration {iteration} kommt zu spät: die Oberfläche ist bei Iteration {now}.</translation>
    </message>
    <message>
        <source>The veto of iteration {iteration} has nothing to forbid: no change of topology happens there.</source>
        <translation>Das Veto für Iteration {iteration} hat nichts zu verbieten: dort ändert sich die Topologie nicht.</translation>
    </message>
    <message>
        <source>The pin {pin} comes too late: the surface is at iteration {now}.</source>
        <translation>Die Fixierung {pin} kommt zu spät: die Oberfläche ist bei Iteration {now}.</translation>
    </message>
    <message>
        <source>The pin {pin} holds nothing: no vertex of the surface lies there at iteration {now}.</source>
        <translation>Die Fixierung {pin} hält nichts: bei Iteration {now} liegt dort keine Ecke der Oberfläche.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} comes too late: the surface is at iteration {now}.</source>
        <translation>Die Bearbeitung für Iteration {iteration} kommt zu spät: die Oberfläche ist bei Iteration {now}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} cannot be made: {cause}.</source>
        <translation>Die Bearbeitung für Iteration {iteration} ist nicht möglich: {cause}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} finds no tunnel at {place}.</source>
        <translation>Die Bearbeitung für Iteration {iteration} findet keinen Tunnel bei {place}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} finds no component at {place}.</source>
        <translation>Die Bearbeitung für Iteration {iteration} findet keine Komponente bei {place}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} finds no cavity at {place}.</source>
        <translation>Die Bearbeitung für Iteration {iteration} findet keinen Hohlraum bei {place}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} cannot be made: no cap fits into the tunnel at {place}.</source>
        <translation>Die Bearbeitung für Iteration {iteration} ist nicht möglich: kein Deckel passt in den Tunnel bei {place}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} finds nothing to remove: there is nothing beside that component.</source>
        <translation>Die Bearbeitung für Iteration {iteration} findet nichts zu entfernen: neben dieser Komponente gibt es nichts.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} would leave nothing of the surface.</source>
        <translation>Die Bearbeitung für Iteration {iteration} ließe nichts von der Oberfläche übrig.</translation>
    </message>
    <message>
        <source>The surface vanished after {iterations} iterations: the seeds are not in an object of that kind and range.</source>
        <translation>Die Oberfläche verschwand nach {iterations} Iterationen: die Startpunkte liegen nicht in einem Objekt dieser Art und dieses Bereichs.</translation>
    </message>
    <message>
        <source>at iteration {iteration} a limit of the topology holds: {cause}; step 4, Grow, asks whether it may happen</source>
        <translation>bei Iteration {iteration} hält eine Grenze der Topologie: {cause}; Schritt 4, Wachsen, fragt, ob es geschehen darf</translation>
    </message>
    <message>
        <source>it would enclose a cavity of {ml:3g} ml at {place:1f}</source>
        <translation>sie würde bei {place:1f} einen Hohlraum von {ml:3g} ml einschließen</translation>
    </message>
    <message>
        <source>a part of {ml:3g} ml would come off at {place:1f}</source>
        <translation>bei {place:1f} würde sich ein Teil von {ml:3g} ml ablösen</translation>
    </message>
    <message>
        <source>its fronts would meet at {place:1f}</source>
        <translation>ihre Fronten würden sich bei {place:1f} treffen</translation>
    </message>
    <message>
        <source>its fronts would meet at {place:1f} and make a tunnel {around_mm:3g} mm around</source>
        <translation>ihre Fronten würden sich bei {place:1f} treffen und einen Tunnel von {around_mm:3g} mm Umfang bilden</translation>
    </message>
    <message>
        <source>a change of its topology ({event}) would happen at {place:1f}</source>
        <translation>bei {place:1f} würde sich ihre Topologie ändern ({event})</translation>
    </message>
    <message>
        <source>its voxels cannot be read: {cause}</source>
        <translation>seine Voxel können nicht gelesen werden: {cause}</translation>
    </message>
    <message>
        <source>no object can be grown here: {cause}</source>
        <translation>hier kann kein Objekt wachsen: {cause}</translation>
    </message>
    <message>
        <source>the surface was still moving at the iteration limit</source>
        <translation>die Oberfläche bewegte sich an der Iterationsgrenze noch</translation>
    </message>
    <message>
        <source>the surface got stuck before it was at rest</source>
        <translation>die Oberfläche blieb stecken, bevor sie ruhte</translation>
    </message>
    <message>
        <source>the surface rests, but parts that could not be mended would still move</source>
        <translation>die Oberfläche ruht, aber Teile, die nicht in Ordnung gebracht werden konnten, würden sich noch bewegen</translation>
    </message>
    <message>
        <source>its voxels cannot be read</source>
        <translation>seine Voxel können nicht gelesen werden</translation>
    </message>
    <message>
        <source>the surface vanished</source>
        <translation>die Oberfläche ist verschwunden</translation>
    </message>
    <message>
        <source>the surface leaked: {cause}</source>
        <translation>die Oberfläche ist ausgelaufen: {cause}</translation>
    </message>
    <message>
        <source>the volume jumps from {from_ml:4g} ml in frame {from_frame} to {to_ml:4g} ml</source>
        <translation>das Volumen springt von {from_ml:4g} ml in Bild {from_frame} auf {to_ml:4g} ml</translation>
    </message>
    <message>
        <source>the topology changes from 1 component of genus {genus_before} to 1 component of genus {genus}</source>
        <translation>die Topologie ändert sich von 1 Komponente mit Geschlecht {genus_before} zu 1 Komponente mit Geschlecht {genus}</translation>
    </message>
    <message>
        <source>the topology changes from 1 component of genus {genus_before} to {components} components of genus {genus}</source>
        <translation>die Topologie ändert sich von 1 Komponente mit Geschlecht {genus_before} zu {components} Komponenten mit Geschlecht {genus}</translation>
    </message>
    <message>
        <source>the topology changes from {components_before} components of genus {genus_before} to 1 component of genus {genus}</source>
        <translation>die Topologie ändert sich von {components_before} Komponenten mit Geschlecht {genus_before} zu 1 Komponente mit Geschlecht {genus}</translation>
    </message>
    <message>
        <source>the topology changes from {components_before} components of genus {genus_before} to {components} components of genus {genus}</source>
        <translation>die Topologie ändert sich von {components_before} Komponenten mit Geschlecht {genus_before} zu {components} Komponenten mit Geschlecht {genus}</translation>
    </message>
    <message>
        <source>the topology was held at 1 place, the first at {place} mm</source>
        <translation>die Topologie wurde an 1 Stelle gehalten, bei {place} mm</translation>
    </message>
    <message>
        <source>the topology was held at {places} places, the first at {place} mm</source>
        <translation>die Topologie wurde an {places} Stellen gehalten, zuerst bei {place} mm</translation>
    </message>
    <message>
        <source>another object is likelier there, but it fails ({cause}); candidate {candidate} was taken</source>
        <translation>ein anderes Objekt ist dort wahrscheinlicher, aber es scheitert ({cause}); Kandidat {candidate} wurde genommen</translation>
    </message>
    <message>
        <source>this is a cine (2D images over time: {frames:0f} frames), not a volume; if its frames are slices in space, enter their spacing in step 1, Open</source>
        <translation>das ist ein Cine (2D-Bilder über die Zeit: {frames:0f}), kein Bildvolumen; liegen die Bilder als Schichten im Raum, geben Sie ihren Abstand in Schritt 1, Öffnen, ein</translation>
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
        <translation>{file}: {cause}, in Zeile {line:0f}.</translation>
    </message>
    <message>
        <source>{file}: cannot be written: {cause}.</source>
        <translation>{file} kann nicht geschrieben werden: {cause}.</translation>
    </message>
    <message>
        <source>{file}: it holds no series {series}.</source>
        <translation>{file}: die Serie {series} ist nicht darin.</translation>
    </message>
    <message>
        <source>{file} cannot be a surface to begin with: it {cause}.</source>
        <translation>{file} kann keine Anfangsoberfläche sein: {cause}.</translation>
    </message>
    <message>
        <source>{file} is not the file that the session began with: its SHA-256 differs.</source>
        <translation>{file} ist nicht die Datei, mit der die Sitzung begann: ihr SHA-256 ist ein anderer.</translation>
    </message>
    <message>
        <source>{file} is not the volume that the session was made from: its SHA-256 differs.</source>
        <translation>{file} ist nicht das Bildvolumen, aus dem die Sitzung gemacht wurde: sein SHA-256 ist ein anderer.</translation>
    </message>
    <message>
        <source>{file} is not the label map that the walls were made from: its SHA-256 differs.</source>
        <translation>{file} ist nicht die Labelkarte, aus der die Wände gemacht wurden: ihr SHA-256 ist ein anderer.</translation>
    </message>
    <message>
        <source>{file} cannot be used as walls: it has {size} voxels, the volume has {volume}.</source>
        <translation>{file} kann nicht für Wände verwendet werden: die Labelkarte hat {size} Voxel, das Bildvolumen {volume}.</translation>
    </message>
    <message>
        <source>{file} cannot be used as walls: its spacing, origin or direction are not the volume's.</source>
        <translation>{file} kann nicht für Wände verwendet werden: Abstand, Ursprung oder Richtung sind nicht die des Bildvolumens.</translation>
    </message>
    <message>
        <source>{file} cannot be used as walls: all of its voxels are 0.</source>
        <translation>{file} kann nicht für Wände verwendet werden: alle Voxel sind 0.</translation>
    </message>
    <message>
        <source>{file} holds no object: all of its voxels are 0.</source>
        <translation>{file} enthält kein Objekt: alle Voxel sind 0.</translation>
    </message>
    <message>
        <source>{file} is hardly a label map: it has more than {most:0f} different values.</source>
        <translation>{file} ist kaum eine Labelkarte: es sind mehr als {most:0f} verschiedene Werte darin.</translation>
    </message>
    <message>
        <source>{file} does not belong to this volume: a surface in it ({object}) lies outside of it.</source>
        <translation>{file} gehört nicht zu diesem Bildvolumen: eine Oberfläche darin ({object}) liegt außerhalb.</translation>
    </message>
    <message>
        <source>{file} is a folder, not a session.</source>
        <translation>{file} ist ein Ordner, keine Sitzung.</translation>
    </message>
    <message>
        <source>{file} cannot be opened: {cause}.</source>
        <translation>{file} kann nicht geöffnet werden: {cause}.</translation>
    </message>
    <message>
        <source>{file} cannot be read.</source>
        <translation>{file} kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>{file} is not a JSON file.</source>
        <translation>{file} ist keine JSON-Datei.</translation>
    </message>
    <message>
        <source>{file} is neither a session nor a report: {cause}</source>
        <translation>{file} ist weder eine Sitzung noch ein Bericht: {cause}</translation>
    </message>
    <message>
        <source>it holds no objects.</source>
        <translation>sie enthält keine Objekte.</translation>
    </message>
    <message>
        <source>it has no seeds.</source>
        <translation>sie hat keine Startpunkte.</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>es gibt keine solche Datei</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>es gibt keine solche Datei und keinen solchen Ordner</translation>
    </message>
    <message>
        <source>it is not a file</source>
        <translation>das ist keine Datei</translation>
    </message>
    <message>
        <source>it is neither a file nor a folder</source>
        <translation>das ist weder eine Datei noch ein Ordner</translation>
    </message>
    <message>
        <source>it cannot be opened (permission?)</source>
        <translation>die Datei kann nicht geöffnet werden (fehlt die Berechtigung?)</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>die Datei kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>it cannot be read</source>
        <translation>die Datei kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>it cannot be read to its end</source>
        <translation>die Datei kann nicht bis zum Ende gelesen werden</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>the folder cannot be read</source>
        <translation>der Ordner kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>the folder cannot be read ({reason})</source>
        <translation>der Ordner kann nicht gelesen werden ({reason})</translation>
    </message>
    <message>
        <source>there is not enough memory to read it</source>
        <translation>zum Lesen reicht der Speicher nicht</translation>
    </message>
    <message>
        <source>not enough memory to decompress it</source>
        <translation>zum Dekomprimieren reicht der Speicher nicht</translation>
    </message>
    <message>
        <source>it is truncated or damaged</source>
        <translation>die Datei ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>it is truncated or damaged ({reason})</source>
        <translation>die Datei ist abgeschnitten oder beschädigt ({reason})</translation>
    </message>
    <message>
        <source>its {format} header cannot be read ({reason})</source>
        <translation>der {format}-Header kann nicht gelesen werden ({reason})</translation>
    </message>
    <message>
        <source>it is truncated within its {format} header</source>
        <translation>die Datei ist im {format}-Header abgeschnitten</translation>
    </message>
    <message>
        <source>its {format} header is truncated</source>
        <translation>der {format}-Header ist abgeschnitten</translation>
    </message>
    <message>
        <source>its {format} header is truncated (no {field})</source>
        <translation>der {format}-Header ist abgeschnitten ({field} fehlt)</translation>
    </message>
    <message>
        <source>its {format} header is damaged ({field})</source>
        <translation>der {format}-Header ist beschädigt ({field})</translation>
    </message>
    <message>
        <source>the {format} file is damaged ({field})</source>
        <translation>die {format}-Datei ist beschädigt ({field})</translation>
    </message>
    <message>
        <source>the {format} file is truncated</source>
        <translation>die {format}-Datei ist abgeschnitten</translation>
    </message>
    <message>
        <source>it is not a {format} file</source>
        <translation>das ist keine {format}-Datei</translation>
    </message>
    <message>
        <source>it is not a volume in a known format (NIfTI, NRRD, MetaImage, DICOM, TIFF, GIPL)</source>
        <translation>das ist kein Bildvolumen in einem bekannten Format (NIfTI, NRRD, MetaImage, DICOM, TIFF, GIPL)</translation>
    </message>
    <message>
        <source>this is a Git LFS pointer, not the file it stands for</source>
        <translation>das ist ein Git-LFS-Zeiger, nicht die Datei, für die er steht</translation>
    </message>
    <message>
        <source>this is a compressed DICOM file; unpack it first (gunzip)</source>
        <translation>das ist eine komprimierte DICOM-Datei; entpacken Sie sie zuerst (gunzip)</translation>
    </message>
    <message>
        <source>this is a sequence of tracked 2D frames, not a volume; reconstruct a volume from it first</source>
        <translation>das ist eine Folge getrackter 2D-Bilder, kein Bildvolumen; rekonstruieren Sie daraus zuerst eines</translation>
    </message>
    <message>
        <source>this is a 2D image, a volume is needed</source>
        <translation>das ist ein 2D-Bild, gebraucht wird ein Bildvolumen</translation>
    </message>
    <message>
        <source>this is a 2D image, a volume needs at least two slices along each axis</source>
        <translation>das ist ein 2D-Bild, ein Bildvolumen braucht mindestens zwei Schichten entlang jeder Achse</translation>
    </message>
    <message>
        <source>this looks like a 2D image in colour (its first axis has {values:0f} values, and the header says nothing of space)</source>
        <translation>das sieht nach einem farbigen 2D-Bild aus (die erste Achse hat {values:0f} Werte, und der Header sagt nichts über den Raum)</translation>
    </message>
    <message>
        <source>the volume has no voxels (a size of 0)</source>
        <translation>das Bildvolumen hat keine Voxel (eine Größe von 0)</translation>
    </message>
    <message>
        <source>the volume has no voxels (a size of 0 in its header)</source>
        <translation>das Bildvolumen hat keine Voxel (eine Größe von 0 im Header)</translation>
    </message>
    <message>
        <source>its voxel spacing is zero, negative or not a number</source>
        <translation>der Voxelabstand ist null, negativ oder keine Zahl</translation>
    </message>
    <message>
        <source>its position or its direction is not a number</source>
        <translation>Lage oder Richtung ist keine Zahl</translation>
    </message>
    <message>
        <source>its axes are not at right angles (sheared or tilted), which is not supported</source>
        <translation>die Achsen stehen nicht im rechten Winkel (geschert oder gekippt), was nicht unterstützt wird</translation>
    </message>
    <message>
        <source>it has no time points</source>
        <translation>es sind keine Zeitpunkte darin</translation>
    </message>
    <message>
        <source>the number of its time points is implausible ({frames:0f})</source>
        <translation>die Anzahl der Zeitpunkte ist unglaubhaft ({frames:0f})</translation>
    </message>
    <message>
        <source>it declares {declared_gb:1f} GB of voxels, more than the {memory_gb:1f} GB of memory of this computer</source>
        <translation>angegeben sind {declared_gb:1f} GB an Voxeln, mehr als die {memory_gb:1f} GB Speicher dieses Rechners</translation>
    </message>
    <message>
        <source>a size in its header is implausible ({size})</source>
        <translation>eine Größe im Header ist unglaubhaft ({size})</translation>
    </message>
    <message>
        <source>its data file {data} is missing</source>
        <translation>die Datendatei {data} fehlt</translation>
    </message>
    <message>
        <source>it is truncated or damaged: the header declares {declared:0f} bytes of voxels, the file holds {held:0f}</source>
        <translation>die Datei ist abgeschnitten oder beschädigt: der Header gibt {declared:0f} Byte an Voxeln an, die Datei enthält {held:0f}</translation>
    </message>
    <message>
        <source>it is truncated or damaged: the header declares {declared:0f} bytes of voxels, the file holds {held:0f} compressed</source>
        <translation>die Datei ist abgeschnitten oder beschädigt: der Header gibt {declared:0f} Byte an Voxeln an, die Datei enthält komprimiert {held:0f}</translation>
    </message>
    <message>
        <source>its voxel data are truncated or damaged</source>
        <translation>die Voxeldaten sind abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>the voxel data are truncated or damaged</source>
        <translation>die Voxeldaten sind abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>the compressed voxel data are truncated or damaged (checksum)</source>
        <translation>die komprimierten Voxeldaten sind abgeschnitten oder beschädigt (Prüfsumme)</translation>
    </message>
    <message>
        <source>1 of its voxels is infinite, the first at index ({index: 0f})</source>
        <translation>1 Voxel ist unendlich, bei Index ({index: 0f})</translation>
    </message>
    <message>
        <source>{voxels:0f} of its voxels are infinite, the first at index ({index: 0f})</source>
        <translation>{voxels:0f} Voxel sind unendlich, das erste bei Index ({index: 0f})</translation>
    </message>
    <message>
        <source>none of its voxels is a number</source>
        <translation>kein Voxel ist eine Zahl</translation>
    </message>
    <message>
        <source>its voxels have {components} components (vectors); only scalar and colour volumes are supported</source>
        <translation>die Voxel haben {components} Komponenten (Vektoren); unterstützt werden nur skalare und farbige Bildvolumen</translation>
    </message>
    <message>
        <source>it has more than four dimensions</source>
        <translation>es sind mehr als vier Dimensionen</translation>
    </message>
    <message>
        <source>it has {dimensions:0f} dimensions; at most four are supported</source>
        <translation>es sind {dimensions:0f} Dimensionen; unterstützt werden höchstens vier</translation>
    </message>
    <message>
        <source>its voxel type ({type}) is not supported</source>
        <translation>der Voxeltyp ({type}) wird nicht unterstützt</translation>
    </message>
    <message>
        <source>its voxel type is not supported</source>
        <translation>der Voxeltyp wird nicht unterstützt</translation>
    </message>
    <message>
        <source>its NIfTI voxel type {type} is not supported</source>
        <translation>der NIfTI-Voxeltyp {type} wird nicht unterstützt</translation>
    </message>
    <message>
        <source>it is not a NIfTI file, whatever its name says</source>
        <translation>das ist keine NIfTI-Datei, was auch immer der Name sagt</translation>
    </message>
    <message>
        <source>this is an Analyze 7.5 file, whose orientation is not reliable; convert it to NIfTI</source>
        <translation>das ist eine Analyze-7.5-Datei, deren Orientierung nicht verlässlich ist; wandeln Sie sie in NIfTI um</translation>
    </message>
    <message>
        <source>the sform in its header has an axis without length</source>
        <translation>die sform im Header hat eine Achse ohne Länge</translation>
    </message>
    <message>
        <source>the sform in its header is not a number</source>
        <translation>die sform im Header ist keine Zahl</translation>
    </message>
    <message>
        <source>its list of data files ({pattern}) is not supported</source>
        <translation>die Liste der Datendateien ({pattern}) wird nicht unterstützt</translation>
    </message>
    <message>
        <source>its encoding ({encoding}) is not supported; raw, gzip and ascii are</source>
        <translation>die Codierung ({encoding}) wird nicht unterstützt; raw, gzip und ascii schon</translation>
    </message>
    <message>
        <source>its data files do not divide its voxels evenly</source>
        <translation>die Datendateien teilen die Voxel nicht gleichmäßig auf</translation>
    </message>
    <message>
        <source>its byte skip of -1 is not supported here</source>
        <translation>der Byte-Skip von -1 wird hier nicht unterstützt</translation>
    </message>
    <message>
        <source>its voxels are not numbers ({word})</source>
        <translation>die Voxel sind keine Zahlen ({word})</translation>
    </message>
    <message>
        <source>its voxels are spread over many data files, which is not supported</source>
        <translation>die Voxel verteilen sich auf viele Datendateien, was nicht unterstützt wird</translation>
    </message>
    <message>
        <source>its voxels are written as text, which is not supported</source>
        <translation>die Voxel sind als Text geschrieben, was nicht unterstützt wird</translation>
    </message>
    <message>
        <source>it has {frames:0f} time points; of the volumes of a folder each is one time point</source>
        <translation>die Datei hat {frames:0f} Zeitpunkte; von den Bildvolumen eines Ordners ist jedes ein Zeitpunkt</translation>
    </message>
    <message>
        <source>its size, spacing or place is not the same as in {first}; the volumes of a folder are the time points of one</source>
        <translation>Größe, Abstand oder Lage ist nicht wie in {first}; die Bildvolumen eines Ordners sind die Zeitpunkte eines einzigen</translation>
    </message>
    <message>
        <source>its voxels are not of the same type and scale as in {first}; the volumes of a folder are the time points of one</source>
        <translation>die Voxel sind nicht von Typ und Skalierung wie in {first}; die Bildvolumen eines Ordners sind die Zeitpunkte eines einzigen</translation>
    </message>
    <message>
        <source>it has {pages:0f} pages; of the TIFF files of a folder each is one slice</source>
        <translation>die Datei hat {pages:0f} Seiten; von den TIFF-Dateien eines Ordners ist jede eine Schicht</translation>
    </message>
    <message>
        <source>its size, resolution or type of voxels is not the same as in {first}; the TIFF files of a folder are the slices of one volume</source>
        <translation>Größe, Auflösung oder Art der Voxel sind andere als in {first}; die TIFF-Dateien eines Ordners sind die Schichten eines Bildvolumens</translation>
    </message>
    <message>
        <source>it is no label map: it has voxels whose values are no whole numbers</source>
        <translation>das ist keine Labelkarte: sie hat Voxel, deren Werte keine ganzen Zahlen sind</translation>
    </message>
    <message>
        <source>the DICOM file is truncated or damaged</source>
        <translation>die DICOM-Datei ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>the file {part} is truncated or damaged</source>
        <translation>die Datei {part} ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>the file {part} is truncated (cut off within its first 132 bytes)</source>
        <translation>die Datei {part} ist abgeschnitten (innerhalb ihrer ersten 132 Byte)</translation>
    </message>
    <message>
        <source>the file {part} is truncated (a slice without an image)</source>
        <translation>die Datei {part} ist abgeschnitten (eine Schicht ohne Bild)</translation>
    </message>
    <message>
        <source>the DICOM header of {part} cannot be read ({reason})</source>
        <translation>der DICOM-Header von {part} kann nicht gelesen werden ({reason})</translation>
    </message>
    <message>
        <source>it is not a DICOM image (no rows and columns)</source>
        <translation>das ist kein DICOM-Bild (keine Zeilen und Spalten)</translation>
    </message>
    <message>
        <source>the folder holds no DICOM images</source>
        <translation>der Ordner enthält keine DICOM-Bilder</translation>
    </message>
    <message>
        <source>the folder holds no DICOM images itself; open one of its subfolders</source>
        <translation>der Ordner selbst enthält keine DICOM-Bilder; öffnen Sie einen seiner Unterordner</translation>
    </message>
    <message>
        <source>the slice {slice} does not say where it lies (position, orientation or pixel spacing)</source>
        <translation>die Schicht {slice} sagt nicht, wo sie liegt (Lage, Orientierung oder Pixelabstand)</translation>
    </message>
    <message>
        <source>the slice {slice} has a pixel spacing that is not positive</source>
        <translation>die Schicht {slice} hat einen Pixelabstand, der nicht positiv ist</translation>
    </message>
    <message>
        <source>the slice {slice} has directions that span no plane</source>
        <translation>die Schicht {slice} hat Richtungen, die keine Ebene aufspannen</translation>
    </message>
    <message>
        <source>the slice {slice} has no pixels</source>
        <translation>die Schicht {slice} hat keine Pixel</translation>
    </message>
    <message>
        <source>the slice {slice} cannot be opened</source>
        <translation>die Schicht {slice} kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>the slice {slice} cannot be read to its end</source>
        <translation>die Schicht {slice} kann nicht bis zum Ende gelesen werden</translation>
    </message>
    <message>
        <source>the slice {slice} has another size than its header says</source>
        <translation>die Schicht {slice} hat eine andere Größe, als ihr Header angibt</translation>
    </message>
    <message>
        <source>the slice {slice} is truncated or damaged ({reason})</source>
        <translation>die Schicht {slice} ist abgeschnitten oder beschädigt ({reason})</translation>
    </message>
    <message>
        <source>the slice {slice} is truncated or damaged (its pixels cannot be decoded)</source>
        <translation>die Schicht {slice} ist abgeschnitten oder beschädigt (ihre Pixel können nicht decodiert werden)</translation>
    </message>
    <message>
        <source>the slice {slice} is truncated or damaged: it holds less pixels than its header says</source>
        <translation>die Schicht {slice} ist abgeschnitten oder beschädigt: sie enthält weniger Pixel, als ihr Header angibt</translation>
    </message>
    <message>
        <source>the slice {slice} is truncated or damaged: its header declares {declared:0f} bytes of pixels, the file holds {held:0f} compressed</source>
        <translation>die Schicht {slice} ist abgeschnitten oder beschädigt: ihr Header gibt {declared:0f} Byte an Pixeln an, die Datei enthält komprimiert {held:0f}</translation>
    </message>
    <message>
        <source>the slice {slice} is damaged: a value is larger than its header allows</source>
        <translation>die Schicht {slice} ist beschädigt: ein Wert ist größer, als ihr Header erlaubt</translation>
    </message>
    <message>
        <source>its slices have different sizes</source>
        <translation>die Schichten haben verschiedene Größen</translation>
    </message>
    <message>
        <source>its slices have different orientations</source>
        <translation>die Schichten haben verschiedene Orientierungen</translation>
    </message>
    <message>
        <source>its slices have different pixel spacings</source>
        <translation>die Schichten haben verschiedene Pixelabstände</translation>
    </message>
    <message>
        <source>its slices are partly in colour</source>
        <translation>ein Teil der Schichten ist farbig</translation>
    </message>
    <message>
        <source>its slices are less than two pixels wide</source>
        <translation>die Schichten sind weniger als zwei Pixel breit</translation>
    </message>
    <message>
        <source>several of its slices lie in the same place with different content, and not equally many in every place (time points or echoes that are not complete)</source>
        <translation>mehrere Schichten liegen mit verschiedenem Inhalt an derselben Stelle, und nicht überall gleich viele (unvollständige Zeitpunkte oder Echos)</translation>
    </message>
    <message>
        <source>all its slices lie in the same place: 2D images over time, not a volume</source>
        <translation>alle Schichten liegen an derselben Stelle: 2D-Bilder über die Zeit, kein Bildvolumen</translation>
    </message>
    <message>
        <source>this is a single slice, a 2D image; give the folder with the whole series</source>
        <translation>das ist eine einzelne Schicht, ein 2D-Bild; geben Sie den Ordner mit der ganzen Serie an</translation>
    </message>
    <message>
        <source>its slices are shifted against each other by {shift_mm:4g} mm, more than they are apart; this is no gantry tilt</source>
        <translation>die Schichten sind um {shift_mm:4g} mm gegeneinander verschoben, mehr als ihr Abstand; das ist keine Gantry-Neigung</translation>
    </message>
    <message>
        <source>{cause}, too unevenly to resample</source>
        <translation>{cause}, zu ungleich zum Resampling</translation>
    </message>
    <message>
        <source>the number of frames in {slice} is implausible</source>
        <translation>die Anzahl der Bilder in {slice} ist unglaubhaft</translation>
    </message>
    <message>
        <source>pixels of {stored:0f} bits in {allocated:0f} are not supported ({slice})</source>
        <translation>Pixel von {stored:0f} Bit in {allocated:0f} werden nicht unterstützt ({slice})</translation>
    </message>
    <message>
        <source>pixels with {samples:0f} samples are not supported ({slice})</source>
        <translation>Pixel mit {samples:0f} Kanälen werden nicht unterstützt ({slice})</translation>
    </message>
    <message>
        <source>colour of {bits:0f} bits is not supported ({slice})</source>
        <translation>Farbe mit {bits:0f} Bit wird nicht unterstützt ({slice})</translation>
    </message>
    <message>
        <source>compressed pixels of one bit are not supported ({slice})</source>
        <translation>komprimierte Pixel von einem Bit werden nicht unterstützt ({slice})</translation>
    </message>
    <message>
        <source>the colour space {space} is not supported ({slice})</source>
        <translation>der Farbraum {space} wird nicht unterstützt ({slice})</translation>
    </message>
    <message>
        <source>it does not say which segment each frame is of</source>
        <translation>es ist nicht angegeben, zu welchem Segment jedes Einzelbild gehört</translation>
    </message>
    <message>
        <source>it is a segmentation that is not binary ({bits:0f} bits per voxel), which is not supported</source>
        <translation>das ist eine Segmentierung, die nicht binär ist ({bits:0f} Bit je Voxel), was nicht unterstützt wird</translation>
    </message>
    <message>
        <source>its pixels are compressed, which is not supported for a segmentation</source>
        <translation>die Pixel sind komprimiert, was bei einer Segmentierung nicht unterstützt wird</translation>
    </message>
    <message>
        <source>it is truncated or damaged: it holds less pixels than its header says</source>
        <translation>die Datei ist abgeschnitten oder beschädigt: sie enthält weniger Pixel, als ihr Header angibt</translation>
    </message>
    <message>
        <source>it does not say where every frame lies</source>
        <translation>es ist nicht angegeben, wo jedes Einzelbild liegt</translation>
    </message>
    <message>
        <source>its frames do not lie one behind the other, which is not supported</source>
        <translation>die Einzelbilder liegen nicht hintereinander, was nicht unterstützt wird</translation>
    </message>
    <message>
        <source>it does not give the distance between its slices</source>
        <translation>der Abstand der Schichten ist nicht angegeben</translation>
    </message>
    <message>
        <source>the distance of its frames is implausible</source>
        <translation>der Abstand der Einzelbilder ist unglaubhaft</translation>
    </message>
    <message>
        <source>its frames are not evenly spaced</source>
        <translation>die Einzelbilder haben ungleiche Abstände</translation>
    </message>
    <message>
        <source>it cannot be read because the decoder {program} is not there</source>
        <translation>die Datei kann nicht gelesen werden, weil der Decoder {program} nicht da ist</translation>
    </message>
    <message>
        <source>the decoder cannot be started ({reason})</source>
        <translation>der Decoder kann nicht gestartet werden ({reason})</translation>
    </message>
    <message>
        <source>the decoder {program} cannot be started ({reason})</source>
        <translation>der Decoder {program} kann nicht gestartet werden ({reason})</translation>
    </message>
    <message>
        <source>the decoder broke down on it ({how}); the file is damaged or too large for it</source>
        <translation>der Decoder ist daran abgestürzt ({how}); die Datei ist beschädigt oder für ihn zu groß</translation>
    </message>
    <message>
        <source>the decoder broke down on {part} ({how}); the file is damaged or too large for it</source>
        <translation>der Decoder ist an {part} abgestürzt ({how}); die Datei ist beschädigt oder für ihn zu groß</translation>
    </message>
    <message>
        <source>the decoder got stuck on it and was stopped; the file is damaged</source>
        <translation>der Decoder blieb daran hängen und wurde beendet; die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>the decoder got stuck on {part} and was stopped; the file is damaged</source>
        <translation>der Decoder blieb an {part} hängen und wurde beendet; die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>the decoder gave an answer without meaning</source>
        <translation>der Decoder gab eine Antwort ohne Sinn</translation>
    </message>
    <message>
        <source>the decoder gave an answer without meaning on it</source>
        <translation>der Decoder gab dazu eine Antwort ohne Sinn</translation>
    </message>
    <message>
        <source>the decoder gave an answer without meaning on {part}</source>
        <translation>der Decoder gab zu {part} eine Antwort ohne Sinn</translation>
    </message>
    <message>
        <source>the decoder gave less than it announced</source>
        <translation>der Decoder gab weniger, als er ankündigte</translation>
    </message>
    <message>
        <source>decoding it takes more memory than its size allows</source>
        <translation>das Decodieren braucht mehr Speicher, als die Größe erlaubt</translation>
    </message>
    <message>
        <source>its data cannot be decoded ({reason})</source>
        <translation>die Daten können nicht decodiert werden ({reason})</translation>
    </message>
    <message>
        <source>the mesh file is truncated or damaged</source>
        <translation>die Netzdatei ist abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>it is not an STL file, or it is truncated</source>
        <translation>das ist keine STL-Datei, oder sie ist abgeschnitten</translation>
    </message>
    <message>
        <source>triangle strips are not supported</source>
        <translation>Dreiecksstreifen werden nicht unterstützt</translation>
    </message>
    <message>
        <source>it holds no triangles</source>
        <translation>es sind keine Dreiecke darin</translation>
    </message>
    <message>
        <source>a coordinate is not a number or infinite</source>
        <translation>eine Koordinate ist keine Zahl oder unendlich</translation>
    </message>
    <message>
        <source>a face names a vertex that is not there</source>
        <translation>eine Fläche nennt eine Ecke, die es nicht gibt</translation>
    </message>
    <message>
        <source>a face has less than three corners</source>
        <translation>eine Fläche hat weniger als drei Ecken</translation>
    </message>
    <message>
        <source>a face is damaged</source>
        <translation>eine Fläche ist beschädigt</translation>
    </message>
    <message>
        <source>a vertex is not three numbers</source>
        <translation>eine Ecke besteht nicht aus drei Zahlen</translation>
    </message>
    <message>
        <source>its triangles have no area</source>
        <translation>die Dreiecke haben keine Fläche</translation>
    </message>
    <message>
        <source>has no triangles</source>
        <translation>es sind keine Dreiecke darin</translation>
    </message>
    <message>
        <source>is not closed</source>
        <translation>das Netz ist nicht geschlossen</translation>
    </message>
    <message>
        <source>is not manifold</source>
        <translation>das Netz ist keine Mannigfaltigkeit</translation>
    </message>
    <message>
        <source>has faces that are not oriented alike</source>
        <translation>das Netz hat Flächen, die nicht gleich orientiert sind</translation>
    </message>
    <message>
        <source>intersects itself ({pairs:0f} pairs of faces)</source>
        <translation>das Netz schneidet sich selbst ({pairs:0f} Flächenpaare)</translation>
    </message>
    <message>
        <source>intersects itself in single precision</source>
        <translation>das Netz schneidet sich selbst in einfacher Genauigkeit</translation>
    </message>
    <message>
        <source>has components that lie where they bound nothing</source>
        <translation>das Netz hat Komponenten, die dort, wo sie liegen, nichts begrenzen</translation>
    </message>
    <message>
        <source>encloses no volume</source>
        <translation>das Netz umschließt kein Volumen</translation>
    </message>
    <message>
        <source>has no voxel of the value {label:0f}</source>
        <translation>es gibt kein Voxel mit dem Wert {label:0f}</translation>
    </message>
    <message>
        <source>has no voxel that is not 0</source>
        <translation>es gibt kein Voxel, das nicht 0 ist</translation>
    </message>
    <message>
        <source>is a mesh, which has no labels</source>
        <translation>das ist ein Netz, das keine Labels hat</translation>
    </message>
    <message>
        <source>became surfaces without the label {label:0f}</source>
        <translation>beim Umwandeln in Oberflächen ging das Label {label:0f} verloren</translation>
    </message>
    <message>
        <source>has labels that lie in each other so finely that their surfaces cannot be kept apart</source>
        <translation>die Labels liegen so fein ineinander, dass ihre Oberflächen nicht getrennt gehalten werden können</translation>
    </message>
    <message>
        <source>has a surface of more than {most:0f} triangles</source>
        <translation>die Oberfläche hätte mehr als {most:0f} Dreiecke</translation>
    </message>
    <message>
        <source>it is a folder, not a file name</source>
        <translation>das ist ein Ordner, kein Dateiname</translation>
    </message>
    <message>
        <source>a folder has this name</source>
        <translation>ein Ordner hat diesen Namen</translation>
    </message>
    <message>
        <source>the data did not reach the disk (is it full?)</source>
        <translation>die Daten kamen nicht auf dem Datenträger an (ist er voll?)</translation>
    </message>
    <message>
        <source>the disk may be full</source>
        <translation>der Datenträger ist vielleicht voll</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>die Datei kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>NIfTI cannot hold more than 32767 voxels or frames along an axis</source>
        <translation>NIfTI kann entlang einer Achse nicht mehr als 32767 Voxel oder Bilder aufnehmen</translation>
    </message>
    <message>
        <source>the mesh is too large for DICOM</source>
        <translation>das Netz ist für DICOM zu groß</translation>
    </message>
    <message>
        <source>it is too large for DICOM</source>
        <translation>es ist für DICOM zu groß</translation>
    </message>
    <message>
        <source>the mesh is too large for 3MF</source>
        <translation>das Netz ist für 3MF zu groß</translation>
    </message>
    <message>
        <source>the object {object} holds the centre of no voxel</source>
        <translation>das Objekt {object} enthält keinen Voxelmittelpunkt</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>die Berechtigung fehlt</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>auf dem Datenträger ist kein Platz mehr</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>auf den Datenträger kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>es gibt keine solche Datei und keinen solchen Ordner</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>der Dateiname ist zu lang</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>ein Teil des Pfads ist kein Ordner</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>das Kontingent auf dem Datenträger ist erschöpft</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Ein-/Ausgabefehler</translation>
    </message>
    <message>
        <source>The pin at {place} mm lies outside of the volume.</source>
        <translation>Die Fixierung bei {place} mm liegt außerhalb des Bildvolumens.</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies outside of the volume.</source>
        <translation>Die Wand bei {place} mm liegt außerhalb des Bildvolumens.</translation>
    </message>
    <message>
        <source>The wall disc at {place} mm lies outside of the volume.</source>
        <translation>Die Wandscheibe bei {place} mm liegt außerhalb des Bildvolumens.</translation>
    </message>
    <message>
        <source>The allowed place {place} lies outside of the volume.</source>
        <translation>Die erlaubte Stelle {place} liegt außerhalb des Bildvolumens.</translation>
    </message>
    <message>
        <source>The place to hold {place} lies outside of the volume.</source>
        <translation>Die Stelle {place}, an der gehalten werden soll, liegt außerhalb des Bildvolumens.</translation>
    </message>
    <message>
        <source>The surface to begin with, {file}, lies outside of the volume.</source>
        <translation>Die Anfangsoberfläche {file} liegt außerhalb des Bildvolumens.</translation>
    </message>
    <message>
        <source>The surface to begin with cannot become another one on the way: begin again.</source>
        <translation>Die Anfangsoberfläche kann unterwegs keine andere werden: beginnen Sie von vorn.</translation>
    </message>
    <message>
        <source>The object '{object}' has no mesh that could be a wall.</source>
        <translation>Das Objekt „{object}“ hat kein Netz, das eine Wand sein könnte.</translation>
    </message>
    <message>
        <source>The label map of the walls has not the volume's size.</source>
        <translation>Die Labelkarte der Wände hat nicht die Größe des Bildvolumens.</translation>
    </message>
    <message>
        <source>An allowed place has nothing to allow: the components and the genus have no limit.</source>
        <translation>Eine erlaubte Stelle hat nichts zu erlauben: Komponenten und Geschlecht haben keine Grenze.</translation>
    </message>
    <message>
        <source>A place to hold has nothing to hold: the components and the genus have no limit.</source>
        <translation>Eine Stelle zum Halten hat nichts zu halten: Komponenten und Geschlecht haben keine Grenze.</translation>
    </message>
    <message>
        <source>There is nothing to ask about: the components and the genus have no limit.</source>
        <translation>Es gibt nichts zu fragen: Komponenten und Geschlecht haben keine Grenze.</translation>
    </message>
    <message>
        <source>A pin cannot be set before the first step of a correction: make a step first.</source>
        <translation>Vor dem ersten Schritt einer Korrektur kann nicht fixiert werden: machen Sie zuerst einen Schritt.</translation>
    </message>
    <message>
        <source>The sensitivity cannot be told of a growth with vetoes, pins or edits: they name an iteration, and a perturbed run has others.</source>
        <translation>Die Empfindlichkeit lässt sich bei einem Wachstum mit Vetos, Fixierungen oder Bearbeitungen nicht angeben: sie nennen eine Iteration, und ein abgewandelter Lauf hat andere.</translation>
    </message>
    <message>
        <source>The surface vanished.</source>
        <translation>Die Oberfläche ist verschwunden.</translation>
    </message>
    <message>
        <source>no DICOM file can be made: {cause}</source>
        <translation>es kann keine DICOM-Datei gemacht werden: {cause}</translation>
    </message>
    <message>
        <source>the volume was not read from DICOM, and a DICOM file belongs to a patient and a study</source>
        <translation>das Bildvolumen wurde nicht aus DICOM gelesen, und eine DICOM-Datei gehört zu einem Patienten und einer Studie</translation>
    </message>
    <message>
        <source>the series does not say where its slices lie</source>
        <translation>die Serie sagt nicht, wo ihre Schichten liegen</translation>
    </message>
    <message>
        <source>its positions are in the frame of the ultrasound volume, not of the patient</source>
        <translation>die Positionen beziehen sich auf das Ultraschallvolumen, nicht auf den Patienten</translation>
    </message>
    <message>
        <source>its spacing was given by the user, not by the series</source>
        <translation>der Abstand wurde von Hand eingegeben, nicht von der Serie angegeben</translation>
    </message>
    <message>
        <source>'{text}' is longer than 64 bytes</source>
        <translation>„{text}“ ist länger als 64 Byte</translation>
    </message>
    <message>
        <source>'{text}' holds a control character or a backslash</source>
        <translation>„{text}“ enthält ein Steuerzeichen oder einen Backslash</translation>
    </message>
    <message>
        <source>the label map is not on the grid of the series</source>
        <translation>die Labelkarte liegt nicht auf dem Gitter der Serie</translation>
    </message>
    <message>
        <source>tetrahedra are made by gmsh or TetGen, and neither program is installed (Debian's packages are gmsh and tetgen)</source>
        <translation>Tetraeder machen gmsh oder TetGen, und keines der beiden Programme ist installiert (die Debian-Pakete heißen gmsh und tetgen)</translation>
    </message>
    <message>
        <source>there are no tetrahedra of the object '{object}': {cause}.</source>
        <translation>vom Objekt „{object}“ gibt es keine Tetraeder: {cause}.</translation>
    </message>
    <message>
        <source>{file}: there is no frame {frame:0f}; it has the frames 0 to {last:0f}.</source>
        <translation>{file}: es gibt kein Bild {frame:0f}; vorhanden sind die Bilder 0 bis {last:0f}.</translation>
    </message>
    <message>
        <source>{file}: there is no frame {frame:0f}; it has one frame, 0.</source>
        <translation>{file}: es gibt kein Bild {frame:0f}; vorhanden ist nur ein Bild, 0.</translation>
    </message>
    <message>
        <source>the slice {slice} holds less frames than its header says</source>
        <translation>die Schicht {slice} enthält weniger Bilder, als ihr Header angibt</translation>
    </message>
    <message>
        <source>the palette of {slice} is missing or damaged</source>
        <translation>die Farbpalette von {slice} fehlt oder ist beschädigt</translation>
    </message>
    <message>
        <source>There are {frames:0f} time points; frame 0 is used (step 1, Open, chooses another).</source>
        <translation>Es gibt {frames:0f} Zeitpunkte; Bild 0 wird verwendet (Schritt 1, Öffnen, wählt ein anderes).</translation>
    </message>
    <message>
        <source>The volume is uncalibrated: its file does not give the spacing, 1 mm is assumed where it is missing, and lengths and volumes mean nothing until it is entered in step 1, Open.</source>
        <translation>Das Bildvolumen ist nicht kalibriert: Die Datei gibt den Voxelabstand nicht an, wo er fehlt, wird 1 mm angenommen, und Längen und Volumen bedeuten nichts, bis er in Schritt 1, Öffnen, eingegeben ist.</translation>
    </message>
    <message>
        <source>stack {stack:0f} ({slices:0f} slices)</source>
        <translation>Stapel {stack:0f} ({slices:0f} Schichten)</translation>
    </message>
    <message>
        <source>it holds {series:0f} series or stacks, choose one in step 1, Open: {choices}</source>
        <translation>darin sind {series:0f} Serien oder Stapel, wählen Sie in Schritt 1, Öffnen: {choices}</translation>
    </message>
    <message>
        <source>No point of the lattice lies in A or B: there is no Dice coefficient.</source>
        <translation>Kein Punkt des Gitters liegt in A oder B: Es gibt keinen Dice-Koeffizienten.</translation>
    </message>
    <message>
        <source>its slices are unevenly spaced ({list})</source>
        <translation>die Schichten haben ungleiche Abstände ({list})</translation>
    </message>
    <message>
        <source>its slices are unevenly spaced ({list}), 1 seems to be missing</source>
        <translation>die Schichten haben ungleiche Abstände ({list}), 1 scheint zu fehlen</translation>
    </message>
    <message>
        <source>its slices are unevenly spaced ({list}), {missing:0f} seem to be missing</source>
        <translation>die Schichten haben ungleiche Abstände ({list}), {missing:0f} scheinen zu fehlen</translation>
    </message>
    <message>
        <source>1 gap of {gap_mm:4g} mm</source>
        <translation>1 Lücke von {gap_mm:4g} mm</translation>
    </message>
    <message>
        <source>{gaps:0f} gaps of {gap_mm:4g} mm</source>
        <translation>{gaps:0f} Lücken von {gap_mm:4g} mm</translation>
    </message>
    <message>
        <source>{gaps:0f} of {gap_mm:4g} mm</source>
        <translation>{gaps:0f} von {gap_mm:4g} mm</translation>
    </message>
    <message>
        <source>{gaps:0f} of {gap_mm:4g} mm …</source>
        <translation>{gaps:0f} von {gap_mm:4g} mm …</translation>
    </message>
    <message>
        <source>Colour was turned into luminance (0.2125 R + 0.7154 G + 0.0721 B).</source>
        <translation>Farbe wurde in Luminanz umgerechnet (0.2125 R + 0.7154 G + 0.0721 B).</translation>
    </message>
    <message>
        <source>The distance unit {unit} is taken as millimetres.</source>
        <translation>Die Längeneinheit {unit} wird als Millimeter verstanden.</translation>
    </message>
    <message>
        <source>The space units {units} are taken as millimetres.</source>
        <translation>Die Einheiten des Raums {units} werden als Millimeter verstanden.</translation>
    </message>
    <message>
        <source>The lengths in the header are in metres and were turned into millimetres.</source>
        <translation>Die Längen im Header sind in Metern und wurden in Millimeter umgerechnet.</translation>
    </message>
    <message>
        <source>The lengths in the header are in micrometres and were turned into millimetres.</source>
        <translation>Die Längen im Header sind in Mikrometern und wurden in Millimeter umgerechnet.</translation>
    </message>
    <message>
        <source>The header does not say how the volume lies in space (qform and sform codes are 0).</source>
        <translation>Der Header sagt nicht, wie das Bildvolumen im Raum liegt (die Codes von qform und sform sind 0).</translation>
    </message>
    <message>
        <source>The header does not say how the volume lies in space; its axes are taken as LPS.</source>
        <translation>Der Header sagt nicht, wie das Bildvolumen im Raum liegt; seine Achsen werden als LPS verstanden.</translation>
    </message>
    <message>
        <source>The sform and the qform of the header disagree (by up to {apart_mm:0f} mm); the qform is used.</source>
        <translation>sform und qform im Header widersprechen sich (um bis zu {apart_mm:0f} mm); die qform wird verwendet.</translation>
    </message>
    <message>
        <source>TIFF does not say how far apart the slices are nor how they lie; 1 mm and LPS axes are assumed.</source>
        <translation>TIFF sagt weder, wie weit die Schichten auseinander sind, noch, wie sie liegen; 1 mm und LPS-Achsen werden angenommen.</translation>
    </message>
    <message>
        <source>This is a segmentation: its voxels hold the numbers of the segments.</source>
        <translation>Das ist eine Segmentierung: Ihre Voxel enthalten die Nummern der Segmente.</translation>
    </message>
    <message>
        <source>The spacing was given by the user; the file says {x_mm:4g} mm, {y_mm:4g} mm, {z_mm:4g} mm.</source>
        <translation>Der Abstand wurde von Hand eingegeben; in der Datei steht {x_mm:4g} mm, {y_mm:4g} mm, {z_mm:4g} mm.</translation>
    </message>
    <message>
        <source>{none:0f} of {voxels:0f} voxels are not a number: they count as outside of the field of view.</source>
        <translation>{none:0f} von {voxels:0f} Voxeln sind keine Zahl: Sie zählen als außerhalb des Bildfelds.</translation>
    </message>
    <message>
        <source>1 slice is a copy of another and was left out.</source>
        <translation>1 Schicht ist die Kopie einer anderen und wurde weggelassen.</translation>
    </message>
    <message>
        <source>{copies:0f} slices are copies of others and were left out.</source>
        <translation>{copies:0f} Schichten sind Kopien anderer und wurden weggelassen.</translation>
    </message>
    <message>
        <source>The slices are tilted by {degrees:1f} degrees (gantry tilt) and were resampled to a straight grid.</source>
        <translation>Die Schichten sind um {degrees:1f} Grad gekippt (Gantry-Kippung) und wurden auf ein gerades Gitter umgerechnet.</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced ({list}); they were resampled to a distance of {spacing_mm:4g} mm. What lies in the gaps is interpolated.</source>
        <translation>Die Schichten haben ungleiche Abstände ({list}); sie wurden auf einen Abstand von {spacing_mm:4g} mm umgerechnet. Was in den Lücken liegt, ist interpoliert.</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced ({list}), 1 seems to be missing; they were resampled to a distance of {spacing_mm:4g} mm. What lies in the gaps is interpolated.</source>
        <translation>Die Schichten haben ungleiche Abstände ({list}), 1 scheint zu fehlen; sie wurden auf einen Abstand von {spacing_mm:4g} mm umgerechnet. Was in den Lücken liegt, ist interpoliert.</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced ({list}), {missing:0f} seem to be missing; they were resampled to a distance of {spacing_mm:4g} mm. What lies in the gaps is interpolated.</source>
        <translation>Die Schichten haben ungleiche Abstände ({list}), {missing:0f} scheinen zu fehlen; sie wurden auf einen Abstand von {spacing_mm:4g} mm umgerechnet. Was in den Lücken liegt, ist interpoliert.</translation>
    </message>
    <message>
        <source>The header does not say where the slices lie; they are taken one behind the other, with LPS axes.</source>
        <translation>Der Header sagt nicht, wo die Schichten liegen; sie werden hintereinander angeordnet, mit LPS-Achsen.</translation>
    </message>
    <message>
        <source>The file does not say how the volume lies in the patient: columns are taken to run to the right, rows to the back and slices downwards.</source>
        <translation>Die Datei sagt nicht, wie das Bildvolumen im Patienten liegt: Es wird angenommen, dass die Spalten nach rechts, die Zeilen nach hinten und die Schichten nach unten laufen.</translation>
    </message>
    <message>
        <source>The file breaks off: its header declares {frames:0f} time points, and only the first one is there in full.</source>
        <translation>Die Datei bricht ab: Der Header nennt {frames:0f} Zeitpunkte, und nur der erste ist vollständig da.</translation>
    </message>
    <message>
        <source>The file breaks off: its header declares {frames:0f} time points, and only the first {whole:0f} are there in full.</source>
        <translation>Die Datei bricht ab: Der Header nennt {frames:0f} Zeitpunkte, und nur die ersten {whole:0f} sind vollständig da.</translation>
    </message>
    <message>
        <source>1 file of DICOM in the folder is without an image and left out.</source>
        <translation>1 DICOM-Datei im Ordner hat kein Bild und bleibt außer Acht.</translation>
    </message>
    <message>
        <source>{files:0f} files of DICOM in the folder are without an image and left out.</source>
        <translation>{files:0f} DICOM-Dateien im Ordner haben kein Bild und bleiben außer Acht.</translation>
    </message>
    <message>
        <source>1 file of other series is truncated or damaged.</source>
        <translation>1 Datei anderer Serien ist abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
        <source>{files:0f} files of other series are truncated or damaged.</source>
        <translation>{files:0f} Dateien anderer Serien sind abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
        <source>1 file in the folder is not DICOM and left out: {names}.</source>
        <translation>1 Datei im Ordner ist nicht DICOM und bleibt außer Acht: {names}.</translation>
    </message>
    <message>
        <source>{files:0f} files in the folder are not DICOM and left out: {names}.</source>
        <translation>{files:0f} Dateien im Ordner sind nicht DICOM und bleiben außer Acht: {names}.</translation>
    </message>
    <message>
        <source>{files:0f} files in the folder are not DICOM and left out: {names} and {more:0f} more.</source>
        <translation>{files:0f} Dateien im Ordner sind nicht DICOM und bleiben außer Acht: {names} und {more:0f} weitere.</translation>
    </message>
    <message>
        <source>1 file in the folder is not DICOM and left out.</source>
        <translation>1 Datei im Ordner ist nicht DICOM und bleibt außer Acht.</translation>
    </message>
    <message>
        <source>{files:0f} files in the folder are not DICOM and left out.</source>
        <translation>{files:0f} Dateien im Ordner sind nicht DICOM und bleiben außer Acht.</translation>
    </message>
    <message>
        <source>Its stacks of one pitch each are to be had alone: {list}.</source>
        <translation>Die Stapel mit je einem Schichtabstand sind einzeln zu haben: {list}.</translation>
    </message>
    <message>
        <source>Its stacks of one pitch each are to be had alone.</source>
        <translation>Die Stapel mit je einem Schichtabstand sind einzeln zu haben.</translation>
    </message>
    <message>
        <source>Nothing is chosen: {cause}.</source>
        <translation>Es ist nichts gewählt: {cause}.</translation>
    </message>
    <message>
        <source>{series} ({what}1 file, {size} voxels of {spacing_mm: 4g} mm)</source>
        <translation>{series} ({what}1 Datei, {size} Voxel von {spacing_mm: 4g} mm)</translation>
    </message>
    <message>
        <source>{series} ({what}{files:0f} files, {size} voxels of {spacing_mm: 4g} mm)</source>
        <translation>{series} ({what}{files:0f} Dateien, {size} Voxel von {spacing_mm: 4g} mm)</translation>
    </message>
    <message>
        <source>{series} ({what}1 file, no volume)</source>
        <translation>{series} ({what}1 Datei, kein Bildvolumen)</translation>
    </message>
    <message>
        <source>{series} ({what}{files:0f} files, no volume)</source>
        <translation>{series} ({what}{files:0f} Dateien, kein Bildvolumen)</translation>
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
        <translation>{object} ist leer: Es gibt keine Abstände.</translation>
    </message>
    <message>
        <source>{object} is not closed: it has no volume, and there is no Dice coefficient. Distances are measured from and to what there is of its surface.</source>
        <translation>{object} ist nicht geschlossen: Das Volumen fehlt, und es gibt keinen Dice-Koeffizienten. Abstände werden von und zu dem gemessen, was von der Oberfläche da ist.</translation>
    </message>
    <message>
        <source>{object} is closed, but not all of its faces are oriented alike: it has no volume, and there is no Dice coefficient.</source>
        <translation>{object} ist geschlossen, aber nicht alle Flächen sind gleich orientiert: Das Volumen fehlt, und es gibt keinen Dice-Koeffizienten.</translation>
    </message>
    <message>
        <source>{object} is not a manifold: its genus and cavities cannot be counted.</source>
        <translation>{object} ist keine Mannigfaltigkeit: Geschlecht und Hohlräume lassen sich nicht zählen.</translation>
    </message>
    <message>
        <source>{object} is inside out; it was turned.</source>
        <translation>{object} ist von innen nach außen gekehrt und wurde umgedreht.</translation>
    </message>
    <message>
        <source>A and B do not overlap: their surfaces are {apart_mm:4g} mm apart, the centres of their boxes {centres_mm:4g} mm.</source>
        <translation>A und B überlappen nicht: Ihre Oberflächen sind {apart_mm:4g} mm voneinander entfernt, die Mitten ihrer Quader {centres_mm:4g} mm.</translation>
    </message>
    <message>
        <source>A and B do not overlap: their surfaces are {apart_mm:4g} mm apart, the centres of their boxes {centres_mm:4g} mm. With the signs of x and y turned in one of them they would meet: is one in RAS and does not say so?</source>
        <translation>A und B überlappen nicht: Ihre Oberflächen sind {apart_mm:4g} mm voneinander entfernt, die Mitten ihrer Quader {centres_mm:4g} mm. Mit umgekehrten Vorzeichen von x und y in einem der beiden würden sie sich treffen: Ist eines in RAS und sagt es nicht?</translation>
    </message>
    <message>
        <source>A part of the surface lies outside of the volume: intensities and label maps are of the rest.</source>
        <translation>Ein Teil der Oberfläche liegt außerhalb des Bildvolumens: Intensitäten und Labelkarten sind die des übrigen.</translation>
    </message>
    <message>
        <source>{voxels:0f} voxels inside have no finite value and do not count.</source>
        <translation>{voxels:0f} Voxel darin haben keinen endlichen Wert und zählen nicht.</translation>
    </message>
    <message>
        <source>No voxel with a value has its centre inside.</source>
        <translation>Von keinem Voxel mit einem Wert liegt die Mitte darin.</translation>
    </message>
    <message>
        <source>“{object}” has no cavity, and so no wall around one.</source>
        <translation>„{object}“ hat keinen Hohlraum und daher keine Wand um einen.</translation>
    </message>
    <message>
        <source>Positions are in the frame of the ultrasound volume, not of the patient: its axes are taken as LPS.</source>
        <translation>Die Positionen beziehen sich auf das Ultraschallvolumen, nicht auf den Patienten: Seine Achsen werden als LPS verstanden.</translation>
    </message>
    <message>
        <source>MONOCHROME1: low values are bright on a display.</source>
        <translation>MONOCHROME1: Niedrige Werte sind auf einer Anzeige hell.</translation>
    </message>
    <message>
        <source>The header scales voxels by 0, which would make them all alike; 1 is taken instead.</source>
        <translation>Der Header skaliert die Voxel mit 0, was sie alle gleich machen würde; stattdessen wird 1 genommen.</translation>
    </message>
    <message>
        <source>it holds several series or stacks, choose one in step 1, Open</source>
        <translation>darin sind mehrere Serien oder Stapel, wählen Sie in Schritt 1, Öffnen</translation>
    </message>
    <message>
        <source>This session does not say where its volume is. Choose it.</source>
        <translation>Diese Sitzung sagt nicht, wo ihr Volumen liegt. Bitte auswählen.</translation>
    </message>
    <message>
        <source>This session does not say where the label map of its walls is. Choose it.</source>
        <translation>Diese Sitzung sagt nicht, wo die Labelkarte ihrer Wände liegt. Bitte auswählen.</translation>
    </message>
    <message>
        <source>This session does not say where the file of a surface is that an object begins with. Choose it.</source>
        <translation>Diese Sitzung sagt nicht, wo die Datei einer Oberfläche liegt, mit der ein Objekt beginnt. Bitte auswählen.</translation>
    </message>
    <message>
        <source>{file}: series {series} is not the one that the session was made from: its voxels differ.</source>
        <translation>{file}: Die Serie {series} ist nicht die, mit der die Sitzung entstanden ist: Ihre Voxel sind andere.</translation>
    </message>
    <message>
        <source>{file}: none of its series has the voxels that the session was made from.</source>
        <translation>{file}: Keine der Serien hat die Voxel, mit denen die Sitzung entstanden ist.</translation>
    </message>
    <message>
        <source>the surface does not enclose the seed at {place:1f} mm, which lies {distance_mm:1f} mm outside of it: the image or other clicks speak against it</source>
        <translation>die Oberfläche schließt den Startpunkt bei {place:1f} mm nicht ein, er liegt {distance_mm:1f} mm außerhalb: das Bild oder andere Punkte sprechen dagegen</translation>
    </message>
    <message>
        <source>the surface encloses the click outside of the object at {place:1f} mm, which lies {distance_mm:1f} mm within it: the image or other clicks speak against it</source>
        <translation>die Oberfläche schließt den Außenpunkt bei {place:1f} mm ein, er liegt {distance_mm:1f} mm innerhalb: das Bild oder andere Punkte sprechen dagegen</translation>
    </message>
    <message>
        <source>The seed at {place:1f} mm and the click outside of the object at {outside:1f} mm contradict each other: both lie in one voxel.</source>
        <translation>Der Startpunkt bei {place:1f} mm und der Außenpunkt bei {outside:1f} mm widersprechen sich: beide liegen im selben Voxel.</translation>
    </message>
    <message>
        <source>the mesh is written as it was given: triangles with an angle under 15 degrees: {thin_faces:0f}, edges whose faces meet at less than 20 degrees: {sharp_edges:0f} (handlebody-cli edit --polish all betters them)</source>
        <translation>Das Netz wird so geschrieben, wie es gegeben war: Dreiecke mit einem Winkel unter 15 Grad: {thin_faces:0f}, Kanten, deren Flächen sich unter weniger als 20 Grad treffen: {sharp_edges:0f} (handlebody-cli edit --polish all bessert sie aus)</translation>
    </message>
    <message>
        <source>The segmentation has {layers:0f} layers, since segments overlap: only the segments of the first layer are read.</source>
        <translation>Die Segmentierung hat {layers:0f} Ebenen, da sich Segmente überlappen: Nur die Segmente der ersten Ebene werden gelesen.</translation>
    </message>
    <message>
        <source>labels of the map that was given overlap: {voxels:0f} voxels of this one are left to smaller ones that hold them, too</source>
        <translation>Labels der angegebenen Karte überlappen sich: {voxels:0f} Voxel von diesem sind kleineren überlassen, die sie auch enthalten</translation>
    </message>
    <message>
        <source>it has no label called '{name}'; it has: {names}</source>
        <translation>darin heißt kein Label „{name}“; es gibt: {names}</translation>
    </message>
    <message>
        <source>it has no label called '{name}': it names none</source>
        <translation>darin heißt kein Label „{name}“: sie nennt keine Namen</translation>
    </message>
    <message>
        <source>it has several labels called '{name}': their number tells them apart</source>
        <translation>darin heißen mehrere Labels „{name}“: ihre Nummer unterscheidet sie</translation>
    </message>
    <message>
        <source>has no voxel of the label {label:0f} that no smaller label holds, too</source>
        <translation>hat keinen Voxel des Labels {label:0f}, den nicht auch ein kleineres Label enthält</translation>
    </message>
    <message>
        <source>has {tunnels:0f} tunnels, and no closing or opening leaves {most:0f} or fewer</source>
        <translation>hat {tunnels:0f} Tunnel, und kein Schließen oder Öffnen lässt höchstens {most:0f} übrig</translation>
    </message>
    <message>
        <source>The surface to begin with, {file}, meets the object '{object}', which comes before it. Labels of one map that touch are kept apart where they are opened together, with the same smoothing, largest part and tunnels.</source>
        <translation>Die Anfangsoberfläche {file} trifft auf das Objekt „{object}“, das vor ihr kommt. Labels einer Karte, die sich berühren, werden auseinandergehalten, wenn sie zusammen geöffnet werden, mit gleicher Glättung, gleichem größten Teil und gleichen Tunneln.</translation>
    </message>
    <message>
        <source>it is not a mesh file (.stl, .vtp, .ply, .obj, .3mf, .stl.dcm)</source>
        <translation>das ist keine Netzdatei (.stl, .vtp, .ply, .obj, .3mf, .stl.dcm)</translation>
    </message>
    <message>
        <source>it is encrypted</source>
        <translation>die Datei ist verschlüsselt</translation>
    </message>
    <message>
        <source>it needs an extension of {format} that is not supported ({extension})</source>
        <translation>die Datei braucht eine Erweiterung von {format}, die nicht unterstützt wird ({extension})</translation>
    </message>
    <message>
        <source>an object begins with one surface or is one, not both.</source>
        <translation>Ein Objekt beginnt mit einer Oberfläche oder ist eine, nicht beides.</translation>
    </message>
    <message>
        <source>The balloon weight must be a number above 0.</source>
        <translation>Das Gewicht des Ballons muss eine Zahl über 0 sein.</translation>
    </message>
    <message>
        <source>The curvature weight must be a number of at least 0.</source>
        <translation>Das Gewicht der Krümmung muss eine Zahl von mindestens 0 sein.</translation>
    </message>
    <message>
        <source>The number of iterations must not be negative.</source>
        <translation>Die Zahl der Iterationen darf nicht negativ sein.</translation>
    </message>
    <message>
        <source>The number of threads must be between 0 and 1024.</source>
        <translation>Die Zahl der Threads muss zwischen 0 und 1024 liegen.</translation>
    </message>
    <message>
        <source>The smoothing must be at least 0 mm.</source>
        <translation>Die Glättung muss mindestens 0 mm betragen.</translation>
    </message>
    <message>
        <source>The edge length must be above 0 mm.</source>
        <translation>Die Kantenlänge muss über 0 mm liegen.</translation>
    </message>
    <message>
        <source>The smoothing of {given_mm} mm is too large for a volume whose longest side is {longest_mm} mm: at most {most_mm} mm.</source>
        <translation>Die Glättung von {given_mm} mm ist zu groß für ein Bildvolumen, dessen längste Seite {longest_mm} mm misst: höchstens {most_mm} mm.</translation>
    </message>
    <message>
        <source>The edge length of {given_mm} mm is too large for a volume whose longest side is {longest_mm} mm: at most {most_mm} mm.</source>
        <translation>Die Kantenlänge von {given_mm} mm ist zu groß für ein Bildvolumen, dessen längste Seite {longest_mm} mm misst: höchstens {most_mm} mm.</translation>
    </message>
    <message>
        <source>The number of components must be at least 1.</source>
        <translation>Die Zahl der Komponenten muss mindestens 1 sein.</translation>
    </message>
    <message>
        <source>The genus must be at least 0.</source>
        <translation>Das Geschlecht muss mindestens 0 sein.</translation>
    </message>
    <message>
        <source>The wall at {place} has no radius above 0 mm.</source>
        <translation>Die Wand bei {place} hat keinen Radius über 0 mm.</translation>
    </message>
    <message>
        <source>The wall disc at {place} has no radius above 0 mm.</source>
        <translation>Die Wandscheibe bei {place} hat keinen Radius über 0 mm.</translation>
    </message>
    <message>
        <source>The wall disc at {place} mm has a normal of no length.</source>
        <translation>Die Wandscheibe bei {place} mm hat eine Normale der Länge null.</translation>
    </message>
    <message>
        <source>The label map of the walls has not been read.</source>
        <translation>Die Labelkarte der Wände ist nicht gelesen worden.</translation>
    </message>
    <message>
        <source>The surface to begin with, {file}, has not been read.</source>
        <translation>Die Oberfläche, mit der begonnen wird, {file}, ist nicht gelesen worden.</translation>
    </message>
    <message>
        <source>A veto needs an iteration of at least 1 and a place.</source>
        <translation>Ein Veto braucht eine Iteration von mindestens 1 und einen Ort.</translation>
    </message>
    <message>
        <source>Iteration {iteration:0f} is an edit: there is nothing that a veto could forbid.</source>
        <translation>Iteration {iteration:0f} ist eine Bearbeitung: dort gibt es nichts, was ein Veto verbieten könnte.</translation>
    </message>
    <message>
        <source>The pin at {place} has no radius above 0 mm.</source>
        <translation>Die Fixierung bei {place} hat keinen Radius über 0 mm.</translation>
    </message>
    <message>
        <source>The pin at {place} mm has an iteration below 0.</source>
        <translation>Die Fixierung bei {place} mm hat eine Iteration unter 0.</translation>
    </message>
    <message>
        <source>An edit needs an iteration of at least 1 and a place.</source>
        <translation>Eine Bearbeitung braucht eine Iteration von mindestens 1 und einen Ort.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} has a number that is not finite.</source>
        <translation>Die Bearbeitung für Iteration {iteration:0f} hat eine Zahl, die nicht endlich ist.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} has no radius above 0 mm.</source>
        <translation>Die Bearbeitung für Iteration {iteration:0f} hat keinen Radius über 0 mm.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} has a radius below 0 mm.</source>
        <translation>Die Bearbeitung für Iteration {iteration:0f} hat einen Radius unter 0 mm.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} has a normal of no length.</source>
        <translation>Die Bearbeitung für Iteration {iteration:0f} hat eine Normale der Länge null.</translation>
    </message>
    <message>
        <source>There are two edits of iteration {iteration:0f}: a step can be one only.</source>
        <translation>Es gibt zwei Bearbeitungen für Iteration {iteration:0f}: ein Schritt kann nur eine sein.</translation>
    </message>
    <message>
        <source>The veto of iteration {iteration:0f} has nothing to forbid: the growth ended at iteration {now:0f}.</source>
        <translation>Das Veto für Iteration {iteration:0f} hat nichts zu verbieten: das Wachstum endete bei Iteration {now:0f}.</translation>
    </message>
    <message>
        <source>The pin {pin} holds nothing: the growth ended at iteration {now:0f}.</source>
        <translation>Die Fixierung {pin} hält nichts: das Wachstum endete bei Iteration {now:0f}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} is never made: the growth ended at iteration {now:0f}.</source>
        <translation>Die Bearbeitung für Iteration {iteration:0f} wird nie ausgeführt: das Wachstum endete bei Iteration {now:0f}.</translation>
    </message>
    <message>
        <source>The surface intersects itself in single precision: the volume lies too far from the origin.</source>
        <translation>Die Oberfläche durchdringt sich selbst in einfacher Genauigkeit: das Bildvolumen liegt zu weit vom Ursprung entfernt.</translation>
    </message>
    <message>
        <source>{sampling_mm:4g} mm between samples would take more than {most:0f} samples of these surfaces.</source>
        <translation>{sampling_mm:4g} mm zwischen Abtastpunkten würden mehr als {most:0f} Abtastpunkte dieser Oberflächen erfordern.</translation>
    </message>
    <message>
        <source>{file}: it {cause}.</source>
        <translation>{file}: {cause}.</translation>
    </message>
    <message>
        <source>the {format} file is damaged ({cause})</source>
        <translation>die {format}-Datei ist beschädigt ({cause})</translation>
    </message>
    <message>
        <source>{part} is missing</source>
        <translation>{part} fehlt</translation>
    </message>
    <message>
        <source>object {object:0f} is missing</source>
        <translation>Objekt {object:0f} fehlt</translation>
    </message>
    <message>
        <source>object {object:0f} holds itself</source>
        <translation>Objekt {object:0f} enthält sich selbst</translation>
    </message>
    <message>
        <source>two objects {object:0f}</source>
        <translation>zwei Objekte mit der Nummer {object:0f}</translation>
    </message>
    <message>
        <source>an object without a number</source>
        <translation>ein Objekt ohne Nummer</translation>
    </message>
    <message>
        <source>too deeply nested components</source>
        <translation>zu tief verschachtelte Komponenten</translation>
    </message>
    <message>
        <source>more than {most:0f} objects and components</source>
        <translation>mehr als {most:0f} Objekte und Komponenten</translation>
    </message>
    <message>
        <source>a component or an item without an object</source>
        <translation>eine Komponente oder ein Element ohne Objekt</translation>
    </message>
    <message>
        <source>a transform that is not twelve numbers</source>
        <translation>eine Transformation, die nicht aus zwölf Zahlen besteht</translation>
    </message>
    <message>
        <source>unit {unit}</source>
        <translation>Einheit {unit}</translation>
    </message>
    <message>
        <source>the compression of {part}</source>
        <translation>die Komprimierung von {part}</translation>
    </message>
    <message>
        <source>the size of {part}</source>
        <translation>die Größe von {part}</translation>
    </message>
    <message>
        <source>{cause} in line {line:0f} of {part}</source>
        <translation>{cause} in Zeile {line:0f} von {part}</translation>
    </message>
    <message>
        <source>XML: {reason}</source>
        <translation>XML-Fehler: {reason}</translation>
    </message>
    <message>
        <source>too deeply nested XML</source>
        <translation>zu tief verschachteltes XML</translation>
    </message>
    <message>
        <source>a document type declaration</source>
        <translation>eine Dokumenttyp-Deklaration</translation>
    </message>
    <message>
        <source>a tag of more than a megabyte</source>
        <translation>ein Tag von mehr als einem Megabyte</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>it has no field '{field}'.</source>
        <translation>ihr fehlt das Feld „{field}“.</translation>
    </message>
    <message>
        <source>this version does not know its field '{field}'.</source>
        <translation>diese Version kennt das Feld „{field}“ darin nicht.</translation>
    </message>
    <message>
        <source>its field '{field}' is not a JSON object.</source>
        <translation>das Feld „{field}“ darin ist kein JSON-Objekt.</translation>
    </message>
    <message>
        <source>its field '{field}' is not a list.</source>
        <translation>das Feld „{field}“ darin ist keine Liste.</translation>
    </message>
    <message>
        <source>its field '{field}' must have {needed:0f} entries; it has {count:0f}.</source>
        <translation>das Feld „{field}“ darin muss {needed:0f} Einträge haben; es hat {count:0f}.</translation>
    </message>
    <message>
        <source>its field '{field}' is not a text.</source>
        <translation>das Feld „{field}“ darin ist kein Text.</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, neither true nor false.</source>
        <translation>das Feld „{field}“ darin ist {value}, weder true noch false.</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, not a number.</source>
        <translation>das Feld „{field}“ darin ist {value}, keine Zahl.</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, not a whole number in range.</source>
        <translation>das Feld „{field}“ darin ist {value}, keine ganze Zahl im möglichen Bereich.</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, and must be at least {least}.</source>
        <translation>das Feld „{field}“ darin ist {value} und muss mindestens {least} sein.</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, and must be above {least}.</source>
        <translation>das Feld „{field}“ darin ist {value} und muss über {least} liegen.</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, and must be from {least:0f} to {most:0f}.</source>
        <translation>das Feld „{field}“ darin ist {value} und muss zwischen {least:0f} und {most:0f} liegen.</translation>
    </message>
    <message>
        <source>its field '{field}' is '{value}', a word that this version does not know.</source>
        <translation>das Feld „{field}“ darin ist „{value}“, ein Wort, das diese Version nicht kennt.</translation>
    </message>
    <message>
        <source>its field '{field}' is empty.</source>
        <translation>das Feld „{field}“ darin ist leer.</translation>
    </message>
    <message>
        <source>its field '{field}' is no range: its lower end is above its upper end.</source>
        <translation>das Feld „{field}“ darin ist kein Bereich: sein unteres Ende liegt über dem oberen.</translation>
    </message>
    <message>
        <source>its field '{field}' is not above that of the entry before it.</source>
        <translation>das Feld „{field}“ darin liegt nicht über dem des Eintrags davor.</translation>
    </message>
    <message>
        <source>its field '{field}' is 0, which is no label.</source>
        <translation>das Feld „{field}“ darin ist 0, was kein Label ist.</translation>
    </message>
    <message>
        <source>its field '{field}' is a vector of no length.</source>
        <translation>das Feld „{field}“ darin ist ein Vektor der Länge null.</translation>
    </message>
    <message>
        <source>its field '{field}' cannot name an object: a name has 1 to {most:0f} characters, no control characters and none of {separators}.</source>
        <translation>das Feld „{field}“ darin kann kein Objekt benennen: ein Name hat 1 bis {most:0f} Zeichen, keine Steuerzeichen und keines von {separators}.</translation>
    </message>
    <message>
        <source>its field '{field}' has a code that is empty, too long, or holds what separates codes.</source>
        <translation>das Feld „{field}“ darin hat einen Code, der leer oder zu lang ist oder ein Zeichen enthält, das Codes trennt.</translation>
    </message>
    <message>
        <source>its field '{field}' is a name that cannot be written into files.</source>
        <translation>das Feld „{field}“ darin ist ein Name, der nicht in Dateien geschrieben werden kann.</translation>
    </message>
    <message>
        <source>it holds a number that is too large.</source>
        <translation>sie enthält eine zu große Zahl.</translation>
    </message>
    <message>
        <source>several objects cannot be carried over time.</source>
        <translation>mehrere Objekte können nicht über die Zeit mitgeführt werden.</translation>
    </message>
    <message>
        <source>a corrected frame begins with the surface of the frame beside it, not with that of a file.</source>
        <translation>ein korrigiertes Bild beginnt mit der Oberfläche des Bildes daneben, nicht mit der einer Datei.</translation>
    </message>
    <message>
        <source>{file} holds {objects:0f} objects, where one is needed; handlebody-cli replay makes them all.</source>
        <translation>{file} enthält {objects:0f} Objekte, wo eines nötig ist; handlebody-cli replay erzeugt sie alle.</translation>
    </message>
    <message>
        <source>{file} is not needed: the session has no walls of a label map.</source>
        <translation>{file} wird nicht gebraucht: die Sitzung hat keine Wände aus einer Labelkarte.</translation>
    </message>
    <message>
        <source>{file} is not needed: nothing in the session begins with a surface.</source>
        <translation>{file} wird nicht gebraucht: nichts in der Sitzung beginnt mit einer Oberfläche.</translation>
    </message>
    <message>
        <source>{file}: the session does not keep which file is meant, so that only one can be; {other} is given, too.</source>
        <translation>{file}: die Sitzung hält nicht fest, welche Datei gemeint ist, sodass es nur eine sein kann; {other} ist ebenfalls angegeben.</translation>
    </message>
    <message>
        <source>{file}: a series is chosen in DICOM alone, this is {format}.</source>
        <translation>{file}: eine Serie wird nur in DICOM gewählt, dies ist {format}.</translation>
    </message>
    <message>
        <source>{file}: a spacing is not above 0.</source>
        <translation>{file}: ein Voxelabstand liegt nicht über 0.</translation>
    </message>
    <message>
        <source>{file}: meshes are written as .stl, .vtp, .ply or .obj.</source>
        <translation>{file}: Netze werden als .stl, .vtp, .ply oder .obj geschrieben.</translation>
    </message>
    <message>
        <source>{file}: a mesh with values is written as .vtp.</source>
        <translation>{file}: ein Netz mit Werten wird als .vtp geschrieben.</translation>
    </message>
    <message>
        <source>{file}: volumes are written as .nii.gz, .nii, .nrrd or .mha.</source>
        <translation>{file}: Bildvolumen werden als .nii.gz, .nii, .nrrd oder .mha geschrieben.</translation>
    </message>
    <message>
        <source>{file}: 4D volumes are written as .nii.gz, .nii or .nrrd.</source>
        <translation>{file}: 4D-Bildvolumen werden als .nii.gz, .nii oder .nrrd geschrieben.</translation>
    </message>
    <message>
        <source>a volume to be written needs at least two voxels along each axis</source>
        <translation>ein Bildvolumen, das geschrieben wird, braucht entlang jeder Achse mindestens zwei Voxel</translation>
    </message>
    <message>
        <source>VTK wrote no scene of it</source>
        <translation>VTK hat keine Szene davon geschrieben</translation>
    </message>
    <message>
        <source>no folder for temporary files can be made: {cause}.</source>
        <translation>es kann kein Ordner für temporäre Dateien angelegt werden: {cause}.</translation>
    </message>
    <message>
        <source>what the clicks mean there agrees to {percent:0f} % (Dice) with the object of frame {from_frame} as the images move it; the latter was taken</source>
        <translation>was die Klicks dort meinen, stimmt zu {percent:0f} % (Dice) mit dem Objekt von Bild {from_frame} überein, wie die Bilder es bewegen; Letzteres wurde genommen</translation>
    </message>
    <message>
        <source>what the clicks mean there fails ({cause}); the object of frame {from_frame} as the images move it was taken</source>
        <translation>was die Klicks dort meinen, scheitert ({cause}); das Objekt von Bild {from_frame}, wie die Bilder es bewegen, wurde genommen</translation>
    </message>
    <message>
        <source>it was carried from frame {from_frame}, whose surface failed</source>
        <translation>die Oberfläche wurde von Bild {from_frame} übernommen, wo sie gescheitert ist</translation>
    </message>
    <message>
        <source>{file} cannot be used as walls: it has {frames:0f} time points, and walls are the same at all of them.</source>
        <translation>{file} kann nicht für Wände verwendet werden: Die Datei hat {frames:0f} Zeitpunkte, und Wände sind an allen dieselben.</translation>
    </message>
    <message>
        <source>There are {frames:0f} time points; the first one is used.</source>
        <translation>Es gibt {frames:0f} Zeitpunkte; der erste wird verwendet.</translation>
    </message>
    <message>
        <source>The header does not say where the first voxel lies; it is taken to lie at 0, 0, 0.</source>
        <translation>Der Header sagt nicht, wo das erste Voxel liegt; angenommen wird 0, 0, 0.</translation>
    </message>
    <message>
        <source>{object} has parts that lie where they bound nothing, as one does that is inside out: it has no volume, and there is no Dice coefficient.</source>
        <translation>{object} hat Teile, die dort, wo sie liegen, nichts begrenzen, etwa weil ihr Inneres außen ist: Es gibt kein Volumen und keinen Dice-Koeffizienten.</translation>
    </message>
    <message>
        <source>The header does not state the distance of the slices: {spacing_mm:4g} mm are taken, the least between its frames, though a slice is {thickness_mm:4g} mm thick. Slices may be left out.</source>
        <translation>Der Header nennt den Abstand der Schichten nicht: Angenommen werden {spacing_mm:4g} mm, der kleinste zwischen seinen Bildern, obwohl eine Schicht {thickness_mm:4g} mm dick ist. Schichten können ausgelassen sein.</translation>
    </message>
    <message>
        <source>the veto of iteration {iteration:0f} forbids nothing: the mesh is that of iteration {mesh_iteration:0f}</source>
        <translation>das Veto für Iteration {iteration:0f} verbietet nichts: das Netz ist das von Iteration {mesh_iteration:0f}</translation>
    </message>
    <message>
        <source>the edit of iteration {iteration:0f} is not made: the mesh is that of iteration {mesh_iteration:0f}</source>
        <translation>die Bearbeitung von Iteration {iteration:0f} ist nicht gemacht: das Netz ist das von Iteration {mesh_iteration:0f}</translation>
    </message>
    <message>
        <source>The volume of the surface, {volume_ml:4g} ml, lies outside of those of all runs with clicks, smoothing and noise a little different, {least_ml:4g} to {most_ml:4g} ml: they may have found another object</source>
        <translation>Das Volumen der Oberfläche, {volume_ml:4g} ml, liegt außerhalb derer aller Läufe mit etwas anderen Klicks, anderer Glättung und anderem Rauschen, {least_ml:4g} bis {most_ml:4g} ml: sie haben vielleicht ein anderes Objekt gefunden</translation>
    </message>
    <message>
        <source>The sensitivity cannot be told of a surface that was given as it is: there is no growth to repeat.</source>
        <translation>Von einer Oberfläche, die so gegeben wurde, wie sie ist, lässt sich keine Empfindlichkeit angeben: es gibt kein Wachstum, das zu wiederholen wäre.</translation>
    </message>
    <message>
        <source>the clicks may mean fewer objects than {asked:0f}, which is the one that was asked for: number {taken:0f}, the last of them, was taken</source>
        <translation>die Klicks können weniger Objekte meinen als {asked:0f}, nach dessen Nummer gefragt war: Nummer {taken:0f}, das letzte von ihnen, wurde genommen</translation>
    </message>
    <message>
        <source>The mesh encloses {mesh_ml:4g} ml, the voxels that it was made of {voxels_ml:4g} ml ({percent:0f} %): they are too few, or too narrow, for their shape to be kept.</source>
        <translation>Das Netz umschließt {mesh_ml:4g} ml, die Voxel, aus denen es entstand, {voxels_ml:4g} ml ({percent:0f} %): es sind zu wenige, oder sie liegen zu schmal, als dass ihre Form erhalten bliebe.</translation>
    </message>
    <message>
        <source>The edges of the mesh are {median_mm:3g} mm long in the median, not {asked_mm:4g} mm as was asked for: with such edges it would leave the voxels or intersect itself.</source>
        <translation>Die Kanten des Netzes sind im Median {median_mm:3g} mm lang, nicht wie verlangt {asked_mm:4g} mm: mit solchen Kanten würde es die Voxel verlassen oder sich selbst schneiden.</translation>
    </message>
    <message>
        <source>the surface reaches {distance_mm:1f} mm into the ball of {radius_mm:1f} mm around the click outside of the object at {place:1f} mm: the image or other clicks speak against it</source>
        <translation>die Oberfläche reicht {distance_mm:1f} mm in die Kugel von {radius_mm:1f} mm um den Außenpunkt bei {place:1f} mm hinein: das Bild oder andere Klicks sprechen dagegen</translation>
    </message>
    <message>
        <source>The seed at {place:1f} mm lies in the ball of {radius_mm:1f} mm around the click outside of the object at {outside:1f} mm: they contradict each other.</source>
        <translation>Der Startpunkt bei {place:1f} mm liegt in der Kugel von {radius_mm:1f} mm um den Außenpunkt bei {outside:1f} mm: sie widersprechen einander.</translation>
    </message>
    <message>
        <source>The click outside of the object at {outside:1f} mm holds the deepest place of the surface to begin with, which stands for the object: give a seed, or another surface.</source>
        <translation>Der Außenpunkt bei {outside:1f} mm enthält die tiefste Stelle der Anfangsoberfläche, die für das Objekt steht: geben Sie einen Startpunkt oder eine andere Oberfläche an.</translation>
    </message>
    <message>
        <source>has no effect on an object that was given: its surface stays as it is, and nothing grows.</source>
        <translation>hat keine Wirkung auf ein Objekt, das gegeben wurde: seine Oberfläche bleibt, wie sie ist, und nichts wächst.</translation>
    </message>
    <message>
        <source>has no effect with a range, by which the intensities alone say what the object is: leave one of them out.</source>
        <translation>hat keine Wirkung mit einem Bereich, bei dem allein die Intensitäten sagen, was das Objekt ist: lassen Sie eines von beiden weg.</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies over the surface that was given, or within it, and that surface stays as it is.</source>
        <translation>Die Wand bei {place} mm liegt über der Oberfläche, die gegeben wurde, oder in ihr, und diese Oberfläche bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>object '{object}' has no seed and is left out.</source>
        <translation>Objekt „{object}“ hat keinen Startpunkt und wird ausgelassen.</translation>
    </message>
    <message>
        <source>{session} was made by version {version}; this is {here}, and the mesh may differ.</source>
        <translation>{session} ist von Version {version}; dies ist {here}, und das Netz kann abweichen.</translation>
    </message>
    <message>
        <source>the session carries the surface through other frames, too, and these figures are of frame {frame:0f} alone; handlebody-cli replay writes those of all.</source>
        <translation>die Sitzung trägt die Oberfläche auch durch andere Bilder, und diese Zahlen sind von Bild {frame:0f} allein; handlebody-cli replay schreibt die von allen.</translation>
    </message>
    <message>
        <source>has no effect: it says how a label becomes a surface, and {file} is a mesh.</source>
        <translation>hat keine Wirkung: es sagt, wie aus einem Label eine Oberfläche wird, und {file} ist ein Netz.</translation>
    </message>
    <message>
        <source>{file} has {count:0f} components, and is to have no more than {most:0f}.</source>
        <translation>{file} hat {count:0f} Komponenten und soll nicht mehr als {most:0f} haben.</translation>
    </message>
    <message>
        <source>{file} has {count:0f} handles or tunnels, and is to have no more than {most:0f}.</source>
        <translation>{file} hat {count:0f} Henkel oder Tunnel und soll nicht mehr als {most:0f} haben.</translation>
    </message>
</context>
<context>
    <name>Sentences</name>
    <message>
        <source> More in the step Open.</source>
        <translation> Mehr im Schritt Öffnen.</translation>
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
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
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
        <translation>%1 mm oder mehr</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>outside: %1</source>
        <translation>außen: %1</translation>
    </message>
    <message>
        <source>inside: %1</source>
        <translation>innen: %1</translation>
    </message>
    <message>
        <source>on the reference: 0 mm</source>
        <translation>auf der Referenz: 0 mm</translation>
    </message>
</context>
<context>
    <name>handlebody::app::Screenshot</name>
    <message>
        <source>There is no seed to grow from: open a session.</source>
        <translation>Es gibt keinen Startpunkt: öffnen Sie eine Sitzung.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>There is no event at iteration %1, and so no stage of it.</source>
        <translation>Bei Iteration %1 gibt es kein Ereignis und damit keine Stufe davon.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Dafür reicht der Speicher nicht.</translation>
    </message>
    <message>
        <source>Something went wrong that has no name.</source>
        <translation>Etwas ohne Namen ist schiefgegangen.</translation>
    </message>
    <message>
        <source>There is no surface yet: grow one first.</source>
        <translation>Es gibt noch keine Oberfläche: lassen Sie zuerst eine wachsen.</translation>
    </message>
    <message>
        <source>There is no centre line in “%1”: %2.</source>
        <translation>In „%1“ gibt es keine Mittellinie: %2.</translation>
    </message>
    <message>
        <source>The first place lies in none of the objects.</source>
        <translation>Die erste Stelle liegt in keinem der Objekte.</translation>
    </message>
    <message>
        <source>Slice %1 of %2</source>
        <translation>Schicht %1 von %2</translation>
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
        <translation>weniger als 1 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>not compared with the image</source>
        <translation>nicht mit dem Bild verglichen</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>nicht verglichen</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>bewegt sich</translation>
    </message>
    <message>
        <source>settled</source>
        <translation>ruht</translation>
    </message>
    <message>
        <source>new handle</source>
        <translation>neuer Henkel</translation>
    </message>
    <message>
        <source>colliding</source>
        <translation>kollidiert</translation>
    </message>
    <message>
        <source>no edge in the image: %1 of the surface</source>
        <translation>keine Kante im Bild: %1 der Oberfläche</translation>
    </message>
    <message>
        <source>edge in the image</source>
        <translation>Kante im Bild</translation>
    </message>
    <message>
        <source>no edge: %1</source>
        <translation>keine Kante: %1</translation>
    </message>
    <message>
        <source>border of the volume</source>
        <translation>Rand des Bildvolumens</translation>
    </message>
    <message>
        <source>pinned</source>
        <translation>fixiert</translation>
    </message>
    <message>
        <source>colliding triangles</source>
        <translation>kollidierende Dreiecke</translation>
    </message>
    <message>
        <source>vertices that are taken out</source>
        <translation>Ecken, die herausgenommen werden</translation>
    </message>
    <message>
        <source>boundary polygons</source>
        <translation>Randpolygone</translation>
    </message>
    <message>
        <source>handle</source>
        <translation>Henkel</translation>
    </message>
    <message>
        <source>closed mesh</source>
        <translation>geschlossenes Netz</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Pinselradius</translation>
    </message>
    <message>
        <source>The brush is a ball, the same for walls and for the surface; Ctrl+wheel changes it while it is on</source>
        <translation>Der Pinsel ist eine Kugel, dieselbe für Wände und für die Oberfläche; Strg+Mausrad ändert sie, solange er an ist</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Open file…</source>
        <translation>&amp;Datei öffnen…</translation>
    </message>
    <message>
        <source>Open &amp;folder…</source>
        <translation>&amp;Ordner öffnen…</translation>
    </message>
    <message>
        <source>Open a folder with a DICOM series</source>
        <translation>Einen Ordner mit einer DICOM-Serie öffnen</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>&amp;Sitzung speichern</translation>
    </message>
    <message>
        <source>Save volume reference, seeds and parameters, to go on later or to replay</source>
        <translation>Verweis auf das Bildvolumen, Startpunkte und Parameter speichern, um später weiterzumachen oder zu wiederholen</translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation>Sitzung speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save the session under another name</source>
        <translation>Die Sitzung unter einem anderen Namen speichern</translation>
    </message>
    <message>
        <source>&amp;Export result…</source>
        <translation>&amp;Ergebnis exportieren…</translation>
    </message>
    <message>
        <source>Write the surface or its label map to a file</source>
        <translation>Die Oberfläche oder ihre Labelkarte in eine Datei schreiben</translation>
    </message>
    <message>
        <source>Export repor&amp;t…</source>
        <translation>&amp;Bericht exportieren…</translation>
    </message>
    <message>
        <source>Write parameters, numbers and events as JSON</source>
        <translation>Parameter, Zahlen und Ereignisse als JSON schreiben</translation>
    </message>
    <message>
        <source>Export &amp;picture…</source>
        <translation>Bild ex&amp;portieren…</translation>
    </message>
    <message>
        <source>Write what the views show as PNG</source>
        <translation>Was die Ansichten zeigen, als PNG schreiben</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Bee&amp;nden</translation>
    </message>
    <message>
        <source>Close the program</source>
        <translation>Das Programm beenden</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Die letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Do again what was taken back</source>
        <translation>Das Zurückgenommene wieder tun</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Layout</source>
        <translation>&amp;Anordnung</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>&amp;Schritt</translation>
    </message>
    <message>
        <source>3D &amp;camera</source>
        <translation>&amp;3D-Kamera</translation>
    </message>
    <message>
        <source>All &amp;four</source>
        <translation>&amp;Alle vier</translation>
    </message>
    <message>
        <source>Axial, 3D, coronal and sagittal view together</source>
        <translation>Axiale, 3D-, koronale und sagittale Ansicht zusammen</translation>
    </message>
    <message>
        <source>&amp;Axial only</source>
        <translation>&amp;Nur axial</translation>
    </message>
    <message>
        <source>Only the axial slice</source>
        <translation>Nur die axiale Schicht</translation>
    </message>
    <message>
        <source>&amp;Coronal only</source>
        <translation>Nur &amp;koronal</translation>
    </message>
    <message>
        <source>Only the coronal slice</source>
        <translation>Nur die koronale Schicht</translation>
    </message>
    <message>
        <source>&amp;Sagittal only</source>
        <translation>Nur &amp;sagittal</translation>
    </message>
    <message>
        <source>Only the sagittal slice</source>
        <translation>Nur die sagittale Schicht</translation>
    </message>
    <message>
        <source>&amp;3D only</source>
        <translation>Nur &amp;3D</translation>
    </message>
    <message>
        <source>Only the surface in 3D</source>
        <translation>Nur die Oberfläche in 3D</translation>
    </message>
    <message>
        <source>1 &amp;Open</source>
        <translation>&amp;1 Öffnen</translation>
    </message>
    <message>
        <source>Choose a volume</source>
        <translation>Ein Bildvolumen wählen</translation>
    </message>
    <message>
        <source>2 &amp;Seed</source>
        <translation>2 &amp;Punkte</translation>
    </message>
    <message>
        <source>Place seeds in the object</source>
        <translation>Startpunkte ins Objekt setzen</translation>
    </message>
    <message>
        <source>3 &amp;Tune</source>
        <translation>&amp;3 Anpassen</translation>
    </message>
    <message>
        <source>Set range and forces</source>
        <translation>Bereich und Kräfte einstellen</translation>
    </message>
    <message>
        <source>4 &amp;Grow</source>
        <translation>&amp;4 Wachsen</translation>
    </message>
    <message>
        <source>Grow the surface and watch it</source>
        <translation>Die Oberfläche wachsen lassen und zusehen</translation>
    </message>
    <message>
        <source>5 &amp;Correct</source>
        <translation>&amp;5 Korrektur</translation>
    </message>
    <message>
        <source>Walls, and what is held back: mend what has grown wrong</source>
        <translation>Wände und was gehalten wird: in Ordnung bringen, was falsch gewachsen ist</translation>
    </message>
    <message>
        <source>6 &amp;Export</source>
        <translation>6 &amp;Export</translation>
    </message>
    <message>
        <source>Write the results</source>
        <translation>Die Ergebnisse schreiben</translation>
    </message>
    <message>
        <source>&amp;Reset views</source>
        <translation>Ansichten &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Whole slices, camera from the front</source>
        <translation>Ganze Schichten, Kamera von vorn</translation>
    </message>
    <message>
        <source>From &amp;above (superior)</source>
        <translation>&amp;Von oben (superior)</translation>
    </message>
    <message>
        <source>3D view: look from superior; with the 3D view in focus</source>
        <translation>3D-Ansicht: von superior; wenn die 3D-Ansicht den Fokus hat</translation>
    </message>
    <message>
        <source>From the &amp;front (anterior)</source>
        <translation>V&amp;on vorn (anterior)</translation>
    </message>
    <message>
        <source>3D view: look from anterior; with the 3D view in focus</source>
        <translation>3D-Ansicht: von anterior; wenn die 3D-Ansicht den Fokus hat</translation>
    </message>
    <message>
        <source>From the &amp;left</source>
        <translation>Von &amp;links</translation>
    </message>
    <message>
        <source>3D view: look from the patient's left; with the 3D view in focus</source>
        <translation>3D-Ansicht: von der linken Seite des Patienten; wenn die 3D-Ansicht den Fokus hat</translation>
    </message>
    <message>
        <source>Slices &amp;in 3D</source>
        <translation>Schichten &amp;in 3D</translation>
    </message>
    <message>
        <source>Show the three slices in the 3D view</source>
        <translation>Die drei Schichten in der 3D-Ansicht zeigen</translation>
    </message>
    <message>
        <source>Walls a&amp;nd pins</source>
        <translation>&amp;Wände und Fixierungen</translation>
    </message>
    <message>
        <source>Draw the active object's walls, and what of its surface is pinned</source>
        <translation>Die Wände des aktiven Objekts zeichnen und was von seiner Oberfläche fixiert ist</translation>
    </message>
    <message>
        <source>CT pr&amp;esets</source>
        <translation>&amp;CT-Vorgaben</translation>
    </message>
    <message>
        <source>C&amp;olour map</source>
        <translation>&amp;Farbtabelle</translation>
    </message>
    <message>
        <source>Sur&amp;face</source>
        <translation>&amp;Oberfläche</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Erscheinungsbild</translation>
    </message>
    <message>
        <source>Langua&amp;ge</source>
        <translation>S&amp;prache</translation>
    </message>
    <message>
        <source>Language of the texts and numbers in the window, from the next start on</source>
        <translation>Sprache der Texte und Zahlen im Fenster, ab dem nächsten Start</translation>
    </message>
    <message>
        <source>&amp;Window and level by dragging</source>
        <translation>Fensterung &amp;durch Ziehen</translation>
    </message>
    <message>
        <source>Drag in a slice: sideways for the window (contrast), up and down for the level (brightness)</source>
        <translation>In einer Schicht ziehen: seitwärts für das Fenster (Kontrast), auf und ab für die Lage (Helligkeit)</translation>
    </message>
    <message>
        <source>Au&amp;to window</source>
        <translation>Au&amp;tomatische Fensterung</translation>
    </message>
    <message>
        <source>Window and level from the intensities of the volume</source>
        <translation>Fenster und Lage aus den Intensitäten des Bildvolumens</translation>
    </message>
    <message>
        <source>&amp;Soft tissue (400 / 40 HU)</source>
        <translation>&amp;Weichteile (400 / 40 HU)</translation>
    </message>
    <message>
        <source>Window 400, level 40</source>
        <translation>Fenster 400, Lage 40</translation>
    </message>
    <message>
        <source>&amp;Lung (1500 / −600 HU)</source>
        <translation>&amp;Lunge (1500 / −600 HU)</translation>
    </message>
    <message>
        <source>Window 1500, level −600</source>
        <translation>Fenster 1500, Lage −600</translation>
    </message>
    <message>
        <source>&amp;Bone (1800 / 400 HU)</source>
        <translation>&amp;Knochen (1800 / 400 HU)</translation>
    </message>
    <message>
        <source>Window 1800, level 400</source>
        <translation>Fenster 1800, Lage 400</translation>
    </message>
    <message>
        <source>B&amp;rain (80 / 40 HU)</source>
        <translation>&amp;Gehirn (80 / 40 HU)</translation>
    </message>
    <message>
        <source>Window 80, level 40</source>
        <translation>Fenster 80, Lage 40</translation>
    </message>
    <message>
        <source>&amp;Vessels (600 / 170 HU)</source>
        <translation>Gefäße (600 / &amp;170 HU)</translation>
    </message>
    <message>
        <source>Window 600, level 170</source>
        <translation>Fenster 600, Lage 170</translation>
    </message>
    <message>
        <source>&amp;Grey</source>
        <translation>&amp;Grau</translation>
    </message>
    <message>
        <source>Black to white</source>
        <translation>Schwarz bis weiß</translation>
    </message>
    <message>
        <source>&amp;Inverted</source>
        <translation>&amp;Invertiert</translation>
    </message>
    <message>
        <source>White to black</source>
        <translation>Weiß bis schwarz</translation>
    </message>
    <message>
        <source>&amp;Hot</source>
        <translation>G&amp;lut</translation>
    </message>
    <message>
        <source>Black over red and yellow to white</source>
        <translation>Schwarz über Rot und Gelb bis Weiß</translation>
    </message>
    <message>
        <source>&amp;Contrast-enhancing</source>
        <translation>&amp;Kontrastverstärkend</translation>
    </message>
    <message>
        <source>Dark intensities spread over many colours, for ultrasound</source>
        <translation>Dunkle Intensitäten über viele Farben gespreizt, für Ultraschall</translation>
    </message>
    <message>
        <source>&amp;Plain</source>
        <translation>&amp;Schlicht</translation>
    </message>
    <message>
        <source>One colour, shaded</source>
        <translation>Eine Farbe, schattiert</translation>
    </message>
    <message>
        <source>With &amp;edges</source>
        <translation>&amp;Mit Kanten</translation>
    </message>
    <message>
        <source>The triangles' edges are drawn</source>
        <translation>Die Kanten der Dreiecke werden gezeichnet</translation>
    </message>
    <message>
        <source>By &amp;state</source>
        <translation>&amp;Nach Zustand</translation>
    </message>
    <message>
        <source>Moving, settled, new handle and colliding faces in their colours</source>
        <translation>Bewegte, ruhende, neue und kollidierende Flächen in ihren Farben</translation>
    </message>
    <message>
        <source>Support by the &amp;image</source>
        <translation>Stütze &amp;durch das Bild</translation>
    </message>
    <message>
        <source>Blue where the image shows no edge, in 3D and on the slices</source>
        <translation>Blau, wo das Bild keine Kante zeigt, in 3D und auf den Schichten</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>Light or dark as the desktop</source>
        <translation>Hell oder dunkel wie die Arbeitsumgebung</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>Dark text on light ground</source>
        <translation>Dunkler Text auf hellem Grund</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>Light text on dark ground</source>
        <translation>Heller Text auf dunklem Grund</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>The window fills the screen</source>
        <translation>Das Fenster füllt den Bildschirm</translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation>&amp;Startpunkt</translation>
    </message>
    <message>
        <source>&amp;Add at the crosshair</source>
        <translation>&amp;Am Fadenkreuz setzen</translation>
    </message>
    <message>
        <source>Place a seed where the crosshair is</source>
        <translation>Einen Startpunkt an das Fadenkreuz setzen</translation>
    </message>
    <message>
        <source>Add &amp;outside of the object</source>
        <translation>Außerhalb des &amp;Objekts setzen</translation>
    </message>
    <message>
        <source>Place a click outside of the object where the crosshair is</source>
        <translation>Einen Außenpunkt an das Fadenkreuz setzen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Delete the selected seed or click outside</source>
        <translation>Den gewählten Start- oder Außenpunkt löschen</translation>
    </message>
    <message>
        <source>&amp;Larger radius</source>
        <translation>&amp;Größerer Radius</translation>
    </message>
    <message>
        <source>Radius of the selected seed half a voxel larger</source>
        <translation>Radius des gewählten Startpunkts ein halbes Voxel größer</translation>
    </message>
    <message>
        <source>&amp;Smaller radius</source>
        <translation>&amp;Kleinerer Radius</translation>
    </message>
    <message>
        <source>Radius of the selected seed half a voxel smaller</source>
        <translation>Radius des gewählten Startpunkts ein halbes Voxel kleiner</translation>
    </message>
    <message>
        <source>Select the &amp;next</source>
        <translation>Den &amp;nächsten wählen</translation>
    </message>
    <message>
        <source>Select the next seed and move the crosshair there</source>
        <translation>Den nächsten Startpunkt wählen und das Fadenkreuz dorthin setzen</translation>
    </message>
    <message>
        <source>S&amp;maller object</source>
        <translation>Kl&amp;eineres Objekt</translation>
    </message>
    <message>
        <source>Take the next smaller of the objects that the clicks may mean</source>
        <translation>Das nächstkleinere der Objekte nehmen, die gemeint sein können</translation>
    </message>
    <message>
        <source>La&amp;rger object</source>
        <translation>G&amp;rößeres Objekt</translation>
    </message>
    <message>
        <source>Take the next larger of the objects that the clicks may mean</source>
        <translation>Das nächstgrößere der Objekte nehmen, die gemeint sein können</translation>
    </message>
    <message>
        <source>&amp;Grow</source>
        <translation>&amp;Wachsen</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Start</translation>
    </message>
    <message>
        <source>Grow the surface, or pause</source>
        <translation>Die Oberfläche wachsen lassen oder anhalten</translation>
    </message>
    <message>
        <source>One step &amp;forward</source>
        <translation>&amp;Ein Schritt vor</translation>
    </message>
    <message>
        <source>One iteration forward</source>
        <translation>Eine Iteration vor</translation>
    </message>
    <message>
        <source>One step &amp;back</source>
        <translation>Ein Schritt &amp;zurück</translation>
    </message>
    <message>
        <source>One iteration back, exactly</source>
        <translation>Eine Iteration zurück, genau</translation>
    </message>
    <message>
        <source>&amp;Next event</source>
        <translation>&amp;Nächstes Ereignis</translation>
    </message>
    <message>
        <source>To the next change of topology; grows until there is one</source>
        <translation>Zur nächsten Änderung der Topologie; wächst, bis eine kommt</translation>
    </message>
    <message>
        <source>&amp;Previous event</source>
        <translation>&amp;Voriges Ereignis</translation>
    </message>
    <message>
        <source>To the previous change of topology</source>
        <translation>Zur vorigen Änderung der Topologie</translation>
    </message>
    <message>
        <source>Back to the s&amp;tart</source>
        <translation>Zurück zum &amp;Anfang</translation>
    </message>
    <message>
        <source>To the seed spheres</source>
        <translation>Zu den Startkugeln</translation>
    </message>
    <message>
        <source>To the &amp;last step</source>
        <translation>Zum &amp;letzten Schritt</translation>
    </message>
    <message>
        <source>To the last iteration that was worked out</source>
        <translation>Zur letzten berechneten Iteration</translation>
    </message>
    <message>
        <source>&amp;Correct</source>
        <translation>&amp;Korrigieren</translation>
    </message>
    <message>
        <source>&amp;Paint walls</source>
        <translation>&amp;Wände malen</translation>
    </message>
    <message>
        <source>Drag in a slice: the surface may not go where it is painted</source>
        <translation>In einer Schicht ziehen: wo gemalt ist, darf die Oberfläche nicht hin</translation>
    </message>
    <message>
        <source>&amp;Erase walls</source>
        <translation>Wände &amp;radieren</translation>
    </message>
    <message>
        <source>Drag in a slice: what the eraser touches is no wall any more</source>
        <translation>In einer Schicht ziehen: was der Radierer berührt, ist keine Wand mehr</translation>
    </message>
    <message>
        <source>&amp;Larger brush</source>
        <translation>&amp;Größerer Pinsel</translation>
    </message>
    <message>
        <source>Radius of the brush a tenth larger</source>
        <translation>Pinselradius ein Zehntel größer</translation>
    </message>
    <message>
        <source>S&amp;maller brush</source>
        <translation>&amp;Kleinerer Pinsel</translation>
    </message>
    <message>
        <source>Radius of the brush a tenth smaller</source>
        <translation>Pinselradius ein Zehntel kleiner</translation>
    </message>
    <message>
        <source>&amp;Wall at the crosshair</source>
        <translation>Wand &amp;am Fadenkreuz</translation>
    </message>
    <message>
        <source>A wall as large as the brush where the crosshair is</source>
        <translation>Eine Wand so groß wie der Pinsel am Fadenkreuz</translation>
    </message>
    <message>
        <source>E&amp;rase at the crosshair</source>
        <translation>Am &amp;Fadenkreuz radieren</translation>
    </message>
    <message>
        <source>No walls where the eraser would touch them at the crosshair</source>
        <translation>Keine Wände, wo der Radierer sie am Fadenkreuz berührt</translation>
    </message>
    <message>
        <source>Go &amp;on from before the walls</source>
        <translation>Weiter &amp;von vor den Wänden</translation>
    </message>
    <message>
        <source>Back to before the surface came to the new walls, and on from there</source>
        <translation>Zurück, bevor die Oberfläche an die neuen Wände kam, und von dort weiter</translation>
    </message>
    <message>
        <source>Remo&amp;ve all walls</source>
        <translation>Alle Wände &amp;entfernen</translation>
    </message>
    <message>
        <source>Nothing that was painted is a wall any more</source>
        <translation>Nichts Gemaltes ist mehr eine Wand</translation>
    </message>
    <message>
        <source>Pin &amp;by brush</source>
        <translation>&amp;Mit dem Pinsel fixieren</translation>
    </message>
    <message>
        <source>Drag over the surface, in a slice or in 3D: what the brush covers stays as it is from the shown iteration on</source>
        <translation>Über die Oberfläche ziehen, in einer Schicht oder in 3D: was der Pinsel bedeckt, bleibt ab der gezeigten Iteration, wie es ist</translation>
    </message>
    <message>
        <source>Unp&amp;in by brush</source>
        <translation>Mit &amp;dem Pinsel lösen</translation>
    </message>
    <message>
        <source>Drag over the surface, in a slice or in 3D: pins that the brush touches hold no more</source>
        <translation>Über die Oberfläche ziehen, in einer Schicht oder in 3D: Fixierungen, die der Pinsel berührt, halten nicht mehr</translation>
    </message>
    <message>
        <source>Smoot&amp;h by brush</source>
        <translation>Mit dem &amp;Pinsel glätten</translation>
    </message>
    <message>
        <source>Click on the surface, in a slice or in 3D: it is smoothed under the brush, as the next step</source>
        <translation>Auf die Oberfläche klicken, in einer Schicht oder in 3D: sie wird unter dem Pinsel geglättet, als nächster Schritt</translation>
    </message>
    <message>
        <source>Pull by &amp;dragging</source>
        <translation>Durch &amp;Ziehen verformen</translation>
    </message>
    <message>
        <source>Drag a point of the surface, in a slice or in 3D: it goes there, and what lies within the brush's radius less and less, as the next step</source>
        <translation>Einen Punkt der Oberfläche ziehen, in einer Schicht oder in 3D: er geht dorthin, und was im Pinselradius liegt, immer weniger mit, als nächster Schritt</translation>
    </message>
    <message>
        <source>Cut alon&amp;g a line</source>
        <translation>Entlang einer &amp;Linie schneiden</translation>
    </message>
    <message>
        <source>Draw a line across the surface in a slice: it is cut there at right angles to the slice, and closed on both sides, as the next step</source>
        <translation>In einer Schicht eine Linie quer über die Oberfläche ziehen: dort wird sie senkrecht zur Schicht geschnitten und auf beiden Seiten geschlossen, als nächster Schritt</translation>
    </message>
    <message>
        <source>Remove &amp;all pins</source>
        <translation>Alle F&amp;ixierungen entfernen</translation>
    </message>
    <message>
        <source>Nothing of the surface is pinned any more</source>
        <translation>Nichts von der Oberfläche ist mehr fixiert</translation>
    </message>
    <message>
        <source>Pi&amp;n here</source>
        <translation>&amp;Hier fixieren</translation>
    </message>
    <message>
        <source>The surface around the crosshair stays as it is from the shown iteration on</source>
        <translation>Die Oberfläche um das Fadenkreuz bleibt ab der gezeigten Iteration, wie sie ist</translation>
    </message>
    <message>
        <source>&amp;Smooth here</source>
        <translation>Hier glä&amp;tten</translation>
    </message>
    <message>
        <source>Smooth the surface around its point nearest to the crosshair, as the next step</source>
        <translation>Die Oberfläche um ihren dem Fadenkreuz nächsten Punkt glätten, als nächster Schritt</translation>
    </message>
    <message>
        <source>P&amp;ull here</source>
        <translation>Hierher ziehe&amp;n</translation>
    </message>
    <message>
        <source>Pull the point of the surface nearest to the crosshair there, as the next step</source>
        <translation>Den dem Fadenkreuz nächsten Punkt der Oberfläche dorthin ziehen, als nächster Schritt</translation>
    </message>
    <message>
        <source>&amp;Cut here</source>
        <translation>Hier &amp;schneiden</translation>
    </message>
    <message>
        <source>Cut along the chosen plane through the crosshair, as the next step</source>
        <translation>Entlang der gewählten Ebene durch das Fadenkreuz schneiden, als nächster Schritt</translation>
    </message>
    <message>
        <source>&amp;Objects</source>
        <translation>&amp;Objekte</translation>
    </message>
    <message>
        <source>&amp;Add object</source>
        <translation>&amp;Objekt hinzufügen</translation>
    </message>
    <message>
        <source>Another object in this volume; the surfaces before it are walls for it</source>
        <translation>Ein weiteres Objekt in diesem Bildvolumen; die Oberflächen davor sind Wände für es</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>Another object with the same seeds and parameters</source>
        <translation>Ein weiteres Objekt mit denselben Startpunkten und Parametern</translation>
    </message>
    <message>
        <source>D&amp;elete object</source>
        <translation>Objekt &amp;löschen</translation>
    </message>
    <message>
        <source>Delete the active object with its seeds and surface</source>
        <translation>Das aktive Objekt mit seinen Startpunkten und seiner Oberfläche löschen</translation>
    </message>
    <message>
        <source>&amp;Properties…</source>
        <translation>&amp;Eigenschaften…</translation>
    </message>
    <message>
        <source>Name, colour, label value and term of the active object</source>
        <translation>Name, Farbe, Labelwert und Begriff des aktiven Objekts</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>&amp;Nach oben</translation>
    </message>
    <message>
        <source>The active object earlier in the list: what two claim belongs to the first</source>
        <translation>Das aktive Objekt früher in der Liste: was zwei beanspruchen, gehört dem ersten</translation>
    </message>
    <message>
        <source>Move do&amp;wn</source>
        <translation>Nach &amp;unten</translation>
    </message>
    <message>
        <source>The active object later in the list</source>
        <translation>Das aktive Objekt später in der Liste: was zwei beanspruchen, gehört dem ersten</translation>
    </message>
    <message>
        <source>&amp;Next object</source>
        <translation>Nä&amp;chstes Objekt</translation>
    </message>
    <message>
        <source>The next object of the list is active</source>
        <translation>Das nächste Objekt der Liste wird aktiv</translation>
    </message>
    <message>
        <source>P&amp;revious object</source>
        <translation>&amp;Voriges Objekt</translation>
    </message>
    <message>
        <source>The object before it in the list is active</source>
        <translation>Das Objekt davor in der Liste wird aktiv</translation>
    </message>
    <message>
        <source>&amp;Visible</source>
        <translation>&amp;Sichtbar</translation>
    </message>
    <message>
        <source>Draw the surface of the active object</source>
        <translation>Die Oberfläche des aktiven Objekts zeichnen</translation>
    </message>
    <message>
        <source>&amp;Locked</source>
        <translation>&amp;Gesperrt</translation>
    </message>
    <message>
        <source>Change nothing of the active object</source>
        <translation>Am aktiven Objekt nichts ändern</translation>
    </message>
    <message>
        <source>&amp;Grow all</source>
        <translation>&amp;Alle wachsen lassen</translation>
    </message>
    <message>
        <source>Grow all objects that are not done, in the order of the list</source>
        <translation>Alle Objekte wachsen lassen, die nicht fertig sind, in der Reihenfolge der Liste</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>&amp;Measures</source>
        <translation>&amp;Messwerte</translation>
    </message>
    <message>
        <source>Volume, area, diameters, intensities and distances of the objects, as a table</source>
        <translation>Volumen, Fläche, Durchmesser, Intensitäten und Abstände der Objekte als Tabelle</translation>
    </message>
    <message>
        <source>&amp;Ruler</source>
        <translation>&amp;Lineal</translation>
    </message>
    <message>
        <source>Click two points in the slices or on the surface: their distance in mm</source>
        <translation>Zwei Punkte in den Schichten oder auf der Oberfläche anklicken: ihr Abstand in mm</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>&amp;Winkel</translation>
    </message>
    <message>
        <source>Click three points, the second where the legs meet: the angle in degrees</source>
        <translation>Drei Punkte anklicken, den zweiten, wo sich die Schenkel treffen: der Winkel in Grad</translation>
    </message>
    <message>
        <source>&amp;Centre line</source>
        <translation>M&amp;ittellinie</translation>
    </message>
    <message>
        <source>Click two places of an object: the line along its middle and the sections across it</source>
        <translation>Zwei Stellen eines Objekts anklicken: die Linie durch seine Mitte und die Querschnitte</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Guide</source>
        <translation>&amp;Anleitung</translation>
    </message>
    <message>
        <source>How to use the program</source>
        <translation>Wie das Programm benutzt wird</translation>
    </message>
    <message>
        <source>&amp;Keyboard and mouse</source>
        <translation>&amp;Tastatur und Maus</translation>
    </message>
    <message>
        <source>All keys and mouse buttons</source>
        <translation>Alle Tasten und Maustasten</translation>
    </message>
    <message>
        <source>&amp;About Handlebody</source>
        <translation>Über &amp;Handlebody</translation>
    </message>
    <message>
        <source>Version, purpose, licences</source>
        <translation>Version, Zweck, Lizenzen</translation>
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
        <translation>Mittlerer Abstand der Oberflächen, ASSD (mm)</translation>
    </message>
    <message>
        <source>95 % Hausdorff distance (mm)</source>
        <translation>95-%-Hausdorff-Abstand (mm)</translation>
    </message>
    <message>
        <source>Hausdorff distance (mm)</source>
        <translation>Hausdorff-Abstand (mm)</translation>
    </message>
    <message>
        <source>Volume (ml)</source>
        <translation>Volumen (ml)</translation>
    </message>
    <message>
        <source>Volume, difference (ml)</source>
        <translation>Volumen, Differenz (ml)</translation>
    </message>
    <message>
        <source>Area (cm²)</source>
        <translation>Fläche (cm²)</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Komponenten</translation>
    </message>
    <message>
        <source>Tunnels</source>
        <translation>Tunnel</translation>
    </message>
    <message>
        <source>Cavities</source>
        <translation>Hohlräume</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>Mouse and keys in a slice</source>
        <translation>Maus und Tasten in einer Schicht</translation>
    </message>
    <message>
        <source>Left click</source>
        <translation>Linksklick</translation>
    </message>
    <message>
        <source>Crosshair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>Return; with Shift</source>
        <translation>Eingabe; mit Umschalt</translation>
    </message>
    <message>
        <source>Seed at the crosshair; click outside of the object</source>
        <translation>Startpunkt am Fadenkreuz; Außenpunkt</translation>
    </message>
    <message>
        <source>Left drag on a seed, on its rim</source>
        <translation>Links auf einem Startpunkt, auf seinem Rand ziehen</translation>
    </message>
    <message>
        <source>Move it, change its radius</source>
        <translation>Verschieben, Radius ändern</translation>
    </message>
    <message>
        <source>Wheel; with Shift</source>
        <translation>Mausrad; mit Umschalt</translation>
    </message>
    <message>
        <source>Next slice; five slices</source>
        <translation>Nächste Schicht; fünf Schichten</translation>
    </message>
    <message>
        <source>Right drag, Ctrl+wheel</source>
        <translation>Rechts ziehen, Strg+Mausrad</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Middle drag, Shift+left drag</source>
        <translation>Mitte ziehen, Umschalt+links ziehen</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Arrows; with Shift</source>
        <translation>Pfeile; mit Umschalt</translation>
    </message>
    <message>
        <source>Crosshair by one voxel; by five</source>
        <translation>Fadenkreuz um ein Voxel; um fünf</translation>
    </message>
    <message>
        <source>Page Up, Page Down</source>
        <translation>Bild auf, Bild ab</translation>
    </message>
    <message>
        <source>Next, previous slice</source>
        <translation>Nächste, vorige Schicht</translation>
    </message>
    <message>
        <source>B or E, then left drag; Ctrl+wheel</source>
        <translation>B oder E, dann links ziehen; Strg+Mausrad</translation>
    </message>
    <message>
        <source>Paint or erase walls; radius of the brush</source>
        <translation>Wände malen oder radieren; Pinselradius</translation>
    </message>
    <message>
        <source>R, A or C, then clicks</source>
        <translation>R, A oder C, dann Klicks</translation>
    </message>
    <message>
        <source>Ruler, angle, centre line: place points; Return: at the crosshair</source>
        <translation>Lineal, Winkel, Mittellinie: Punkte setzen; Eingabe: am Fadenkreuz</translation>
    </message>
    <message>
        <source>Left drag on the end of a ruler or an angle</source>
        <translation>Links am Ende eines Lineals oder Winkels ziehen</translation>
    </message>
    <message>
        <source>Move it</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>L or Shift+L, then left drag</source>
        <translation>L oder Umschalt+L, dann links ziehen</translation>
    </message>
    <message>
        <source>Pin or unpin the surface under the brush</source>
        <translation>Die Oberfläche unter dem Pinsel fixieren oder lösen</translation>
    </message>
    <message>
        <source>M, then left click</source>
        <translation>M, dann Linksklick</translation>
    </message>
    <message>
        <source>Smooth the surface under the brush</source>
        <translation>Die Oberfläche unter dem Pinsel glätten</translation>
    </message>
    <message>
        <source>U, then left drag from the outline</source>
        <translation>U, dann links vom Umriss ziehen</translation>
    </message>
    <message>
        <source>Pull the surface by that point</source>
        <translation>Die Oberfläche an diesem Punkt ziehen</translation>
    </message>
    <message>
        <source>X, then left drag across the outline</source>
        <translation>X, dann links quer über den Umriss ziehen</translation>
    </message>
    <message>
        <source>Cut the surface along that line</source>
        <translation>Die Oberfläche entlang dieser Linie schneiden</translation>
    </message>
    <message>
        <source>W, then left drag</source>
        <translation>W, dann links ziehen</translation>
    </message>
    <message>
        <source>Window (sideways) and level (up and down)</source>
        <translation>Fenster (seitwärts) und Lage (auf und ab)</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>This view alone, or all four</source>
        <translation>Diese Ansicht allein oder alle vier</translation>
    </message>
    <message>
        <source>Mouse in the 3D view</source>
        <translation>Maus in der 3D-Ansicht</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>Links ziehen</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>L, Shift+L, M or U, then left on the surface</source>
        <translation>L, Umschalt+L, M oder U, dann links auf der Oberfläche</translation>
    </message>
    <message>
        <source>Pin, unpin, smooth, pull; beside it: rotate</source>
        <translation>Fixieren, lösen, glätten, ziehen; daneben: drehen</translation>
    </message>
    <message>
        <source>R, A or C, then clicks on the surface</source>
        <translation>R, A oder C, dann Klicks auf die Oberfläche</translation>
    </message>
    <message>
        <source>Ruler, angle, centre line: place points</source>
        <translation>Lineal, Winkel, Mittellinie: Punkte setzen</translation>
    </message>
    <message>
        <source>Right drag, wheel</source>
        <translation>Rechts ziehen, Mausrad</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Close the message over the views; else give up a stroke or a point, put brush and ruler away, leave window and level</source>
        <translation>Die Meldung über den Ansichten schließen; sonst einen Strich oder Punkt aufgeben, Pinsel und Lineal weglegen, die Fensterung verlassen</translation>
    </message>
    <message>
        <source>window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>3D view, mesh files, pictures</source>
        <translation>3D-Ansicht, Netzdateien, Bilder</translation>
    </message>
    <message>
        <source>reading and writing volumes</source>
        <translation>Bildvolumen lesen und schreiben</translation>
    </message>
    <message>
        <source>linear algebra</source>
        <translation>lineare Algebra</translation>
    </message>
    <message>
        <source>SHA-256 of volumes</source>
        <translation>SHA-256 der Bildvolumen</translation>
    </message>
    <message>
        <source>compressed files</source>
        <translation>komprimierte Dateien</translation>
    </message>
    <message>
        <source>sessions and reports</source>
        <translation>Sitzungen und Berichte</translation>
    </message>
    <message>
        <source>command line</source>
        <translation>Befehlszeile</translation>
    </message>
    <message>
        <source>Keyboard and mouse</source>
        <translation>Tastatur und Maus</translation>
    </message>
    <message>
        <source>Grows a certified surface from a point in a medical volume; the surface may change its topology on the way.</source>
        <translation>Lässt von einem Punkt in einem medizinischen Bildvolumen aus eine zertifizierte Oberfläche wachsen, deren Topologie sich unterwegs ändern darf.</translation>
    </message>
    <message>
        <source>Apache License 2.0. The method is that of the paper “A Combinatorial Method for Topology Adaptations in 3D Deformable Models”.</source>
        <translation>Apache-Lizenz 2.0. Das Verfahren ist das des Artikels „A Combinatorial Method for Topology Adaptations in 3D Deformable Models“.</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>Bibliotheken</translation>
    </message>
    <message>
        <source>Qt is linked dynamically and can be replaced by another version of it.</source>
        <translation>Qt ist dynamisch gebunden und kann durch eine andere Version ersetzt werden.</translation>
    </message>
    <message>
        <source>For research use only. Handlebody is not a medical device; do not use it for diagnosis or treatment.</source>
        <translation>Nur für Forschungszwecke. Handlebody ist kein Medizinprodukt; verwenden Sie es nicht für Diagnose oder Behandlung.</translation>
    </message>
    <message>
        <source>they meet</source>
        <translation>sie treffen sich</translation>
    </message>
    <message>
        <source>%1, one within the other</source>
        <translation>%1, eins im anderen</translation>
    </message>
    <message>
        <source>  from %1: mean %2, least %3, 95 % up to %4, largest %5</source>
        <translation>  von %1: Mittel %2, kleinster %3, 95 % bis %4, größter %5</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
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
        <translation>Fläche
(cm²)</translation>
    </message>
    <message>
        <source>Largest
Ø (mm)</source>
        <translation>Größter
Ø (mm)</translation>
    </message>
    <message>
        <source>Intensity
mean ± SD</source>
        <translation>Intensität
Mittel ± SA</translation>
    </message>
    <message>
        <source>Nearest object
(mm)</source>
        <translation>Nächstes Objekt
(mm)</translation>
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
        <translation>Entlang seiner Achsen: %1 mm</translation>
    </message>
    <message>
        <source>Along x, y, z: %1 mm</source>
        <translation>Entlang x, y, z: %1 mm</translation>
    </message>
    <message>
        <source>Largest Ø from %1 to %2</source>
        <translation>Größter Ø von %1 bis %2</translation>
    </message>
    <message>
        <source>Centroid: %1 LPS</source>
        <translation>Schwerpunkt: %1 LPS</translation>
    </message>
    <message>
        <source>Intensity %1 to %2, %3 voxels</source>
        <translation>Intensität %1 bis %2, %3 Voxel</translation>
    </message>
    <message>
        <source>Components %1, cavities %2, tunnels %3</source>
        <translation>Komponenten %1, Hohlräume %2, Tunnel %3</translation>
    </message>
    <message>
        <source>Distance to “%1”: %2</source>
        <translation>Abstand zu „%1“: %2</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>Wanddicke</translation>
    </message>
    <message>
        <source>Length %1, in “%2”</source>
        <translation>Länge %1, in „%2“</translation>
    </message>
    <message>
        <source>Least section: %1</source>
        <translation>Kleinster Querschnitt: %1</translation>
    </message>
    <message>
        <source>Largest: %1</source>
        <translation>Größter: %1</translation>
    </message>
    <message>
        <source>at %1: no section</source>
        <translation>bei %1: kein Querschnitt</translation>
    </message>
    <message>
        <source>at %1: %2 mm², Ø %3</source>
        <translation>bei %1: %2 mm², Ø %3</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Bedienfelder</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Standard deviation of the Gaussian that smooths the image ahead. More for more speckle; 0 for none.</source>
        <translation>Standardabweichung der Gauß-Funktion, die das Bild vorab glättet. Mehr bei mehr Speckle; 0 für keine.</translation>
    </message>
    <message>
        <source>Edge length</source>
        <translation>Kantenlänge</translation>
    </message>
    <message>
        <source>Length that the edges of the mesh are kept near. Shorter shows finer detail and takes longer.</source>
        <translation>Länge, nahe der die Kanten des Netzes gehalten werden. Kürzere zeigen feinere Einzelheiten und dauern länger.</translation>
    </message>
    <message>
        <source>Balloon</source>
        <translation>Ballon</translation>
    </message>
    <message>
        <source>Weight of the force that drives the surface outward. Less keeps it from leaking.</source>
        <translation>Gewicht der Kraft, die die Oberfläche nach außen treibt. Weniger verhindert Auslaufen.</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>Weight of smoothness. More closes narrow leaks and rounds the surface off.</source>
        <translation>Gewicht der Glattheit. Mehr schließt enge Lecks und rundet die Oberfläche.</translation>
    </message>
    <message>
        <source>Iteration limit</source>
        <translation>Iterationsgrenze</translation>
    </message>
    <message>
        <source>The growth stops after so many iterations, finished or not.</source>
        <translation>Das Wachstum endet nach so vielen Iterationen, fertig oder nicht.</translation>
    </message>
    <message>
        <source>The file cannot be read.</source>
        <translation>Die Datei kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The file cannot be written.</source>
        <translation>Die Datei kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Open a volume (NIfTI, NRRD, MetaImage, GIPL, TIFF, DICOM) or a session</source>
        <translation>Ein Bildvolumen (NIfTI, NRRD, MetaImage, GIPL, TIFF, DICOM) oder eine Sitzung öffnen</translation>
    </message>
    <message>
        <source>Open o&amp;bjects…</source>
        <translation>Ob&amp;jekte öffnen…</translation>
    </message>
    <message>
        <source>Take surfaces of a mesh (STL, VTP, PLY, OBJ, 3MF) or a label map (DICOM, 3D Slicer, NIfTI, NRRD, MetaImage) as objects: as they are, or to grow from</source>
        <translation>Oberflächen eines Netzes (STL, VTP, PLY, OBJ, 3MF) oder einer Labelkarte (DICOM, 3D Slicer, NIfTI, NRRD, MetaImage) als Objekte übernehmen: wie sie sind, oder um von ihnen aus zu wachsen</translation>
    </message>
    <message>
        <source>&amp;Time</source>
        <translation>&amp;Zeit</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>Play the frames of the volume, or stop</source>
        <translation>Die Bilder des Bildvolumens abspielen oder anhalten</translation>
    </message>
    <message>
        <source>P&amp;revious frame</source>
        <translation>Vo&amp;riges Bild</translation>
    </message>
    <message>
        <source>The frame before the shown one</source>
        <translation>Das Bild vor dem gezeigten</translation>
    </message>
    <message>
        <source>&amp;Next frame</source>
        <translation>&amp;Nächstes Bild</translation>
    </message>
    <message>
        <source>The frame after the shown one</source>
        <translation>Das Bild nach dem gezeigten</translation>
    </message>
    <message>
        <source>&amp;Back to where it is grown</source>
        <translation>&amp;Zurück, wo sie gewachsen ist</translation>
    </message>
    <message>
        <source>The frame in which the surface is grown</source>
        <translation>Das Bild, in dem die Oberfläche wächst</translation>
    </message>
    <message>
        <source>&amp;Grow in this frame</source>
        <translation>In d&amp;iesem Bild wachsen</translation>
    </message>
    <message>
        <source>Grow in the shown frame with the same clicks; what was grown in the other one is gone</source>
        <translation>Im gezeigten Bild mit denselben Punkten wachsen; was im anderen gewachsen ist, entfällt</translation>
    </message>
    <message>
        <source>&amp;Over time</source>
        <translation>Ü&amp;ber die Zeit</translation>
    </message>
    <message>
        <source>Carry the surface from its frame through the others, both ways, in the background</source>
        <translation>Die Oberfläche im Hintergrund von ihrem Bild aus in beide Richtungen durch die anderen tragen</translation>
    </message>
    <message>
        <source>&amp;Correct this frame</source>
        <translation>Dieses Bild &amp;korrigieren</translation>
    </message>
    <message>
        <source>Change the surface of the shown frame with clicks, walls and edits, from that of the frame beside it on</source>
        <translation>Die Oberfläche des gezeigten Bildes mit Punkten, Wänden und Bearbeitungen ändern, ausgehend von der des Bildes daneben</translation>
    </message>
    <message>
        <source>Carry on &amp;from here</source>
        <translation>Von hier aus &amp;fortfahren</translation>
    </message>
    <message>
        <source>The correction counts: the frames beyond this one are carried again from it</source>
        <translation>Die Korrektur gilt: Die Bilder dahinter werden von diesem aus neu bestimmt</translation>
    </message>
    <message>
        <source>&amp;Drop the correction</source>
        <translation>Korrektur ver&amp;werfen</translation>
    </message>
    <message>
        <source>Back to the frame that is grown; what was carried stays as it was</source>
        <translation>Zurück zum gewachsenen Bild; was übertragen wurde, bleibt, wie es war</translation>
    </message>
    <message>
        <source>&amp;Volume over time</source>
        <translation>&amp;Volumen über die Zeit</translation>
    </message>
    <message>
        <source>The volume of every frame, ejection fraction, and what went wrong in which frame</source>
        <translation>Das Volumen jedes Bildes, die Ejektionsfraktion und was in welchem Bild misslang</translation>
    </message>
    <message>
        <source>Export &amp;meshes of all frames…</source>
        <translation>N&amp;etze aller Bilder exportieren…</translation>
    </message>
    <message>
        <source>Write the surface of every frame, numbered, with a list for ParaView (.pvd) beside .vtp</source>
        <translation>Die Oberfläche jedes Bildes nummeriert schreiben, bei .vtp mit einer Liste für ParaView (.pvd)</translation>
    </message>
    <message>
        <source>Export 4D &amp;label map…</source>
        <translation>4D-&amp;Labelkarte exportieren…</translation>
    </message>
    <message>
        <source>Write the surfaces of all frames as one label map with four dimensions</source>
        <translation>Die Oberflächen aller Bilder als eine Labelkarte mit vier Dimensionen schreiben</translation>
    </message>
    <message>
        <source>&amp;Sensitivity</source>
        <translation>&amp;Empfindlichkeit</translation>
    </message>
    <message>
        <source>Grow it again with clicks, smoothing and noise a little different: how much do volume and surface change?</source>
        <translation>Mit etwas anderen Punkten, Glättung und Rauschen neu wachsen: Wie sehr ändern sich Volumen und Oberfläche?</translation>
    </message>
    <message>
        <source>Export a&amp;nonymous session…</source>
        <translation>Anon&amp;yme Sitzung exportieren…</translation>
    </message>
    <message>
        <source>Write a session that names neither the patient nor a file: it asks for its volume when it is opened</source>
        <translation>Schreibt eine Sitzung, die weder Patienten noch Dateien nennt: Beim Öffnen fragt sie nach ihrem Volumen</translation>
    </message>
    <message>
        <source>the first point lies outside of the object</source>
        <translation>der erste Punkt liegt außerhalb des Objekts</translation>
    </message>
    <message>
        <source>the second point lies outside of the object</source>
        <translation>der zweite Punkt liegt außerhalb des Objekts</translation>
    </message>
    <message>
        <source>the two points lie in the same place of the object</source>
        <translation>beide Punkte liegen an derselben Stelle des Objekts</translation>
    </message>
    <message>
        <source>the way between them is too long and thin to be searched</source>
        <translation>der Weg zwischen ihnen ist zu lang und dünn, um durchsucht zu werden</translation>
    </message>
    <message>
        <source>there is no way from one to the other inside of the object</source>
        <translation>im Innern des Objekts führt kein Weg vom einen zum anderen</translation>
    </message>
    <message>
        <source>3MF files</source>
        <translation>3MF-Dateien</translation>
    </message>
    <message>
        <source>the outer surface</source>
        <translation>der äußeren Oberfläche</translation>
    </message>
    <message>
        <source>the cavities</source>
        <translation>den Hohlräumen</translation>
    </message>
    <message>
        <source>writing DICOM files</source>
        <translation>DICOM-Dateien schreiben</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::CentreLinePage</name>
    <message>
        <source>The centre line</source>
        <translation>Die Mittellinie</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Als CSV speichern…</translation>
    </message>
    <message>
        <source>Save as CSV</source>
        <translation>Als CSV speichern</translation>
    </message>
    <message>
        <source>The same table as “handlebody-cli measure --sections” writes</source>
        <translation>Dieselbe Tabelle, die „handlebody-cli measure --sections“ schreibt</translation>
    </message>
    <message>
        <source>Save the sections</source>
        <translation>Die Querschnitte speichern</translation>
    </message>
    <message>
        <source>Between two places in an object, along its middle.</source>
        <translation>Zwischen zwei Stellen in einem Objekt, entlang seiner Mitte.</translation>
    </message>
    <message>
        <source>Click in the object or on its surface where the line begins, or press Return for the crosshair.</source>
        <translation>Klicken Sie ins Objekt oder auf seine Oberfläche, wo die Linie beginnt, oder drücken Sie die Eingabetaste für das Fadenkreuz.</translation>
    </message>
    <message>
        <source>Click where it ends. Escape takes the beginning back.</source>
        <translation>Klicken Sie, wo sie endet. Escape nimmt den Anfang zurück.</translation>
    </message>
    <message>
        <source>Searching for the middle of the object…</source>
        <translation>Die Mitte des Objekts wird gesucht…</translation>
    </message>
    <message>
        <source>Pointed at: %1</source>
        <translation>Gezeigt auf: %1</translation>
    </message>
    <message>
        <source>It was made in an earlier surface.</source>
        <translation>Sie wurde in einer früheren Oberfläche gemacht.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Search no longer</source>
        <translation>Nicht weiter suchen</translation>
    </message>
    <message>
        <source>Draw the line no more</source>
        <translation>Die Linie nicht mehr zeichnen</translation>
    </message>
    <message>
        <source>Save as JSON…</source>
        <translation>Als JSON speichern…</translation>
    </message>
    <message>
        <source>Save as JSON</source>
        <translation>Als JSON speichern</translation>
    </message>
    <message>
        <source>The same as “handlebody-cli measure --json” writes of the line</source>
        <translation>Dasselbe, was „handlebody-cli measure --json“ von der Linie schreibt</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ComparePage</name>
    <message>
        <source>Figure</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>The object beside the reference</source>
        <translation>Das Objekt neben der Referenz</translation>
    </message>
    <message>
        <source>Save the comparison</source>
        <translation>Den Vergleich speichern</translation>
    </message>
    <message>
        <source>Choose reference…</source>
        <translation>Referenz wählen…</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Compare the shown surface with the reference</source>
        <translation>Die gezeigte Oberfläche mit der Referenz vergleichen</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Als CSV speichern…</translation>
    </message>
    <message>
        <source>The same table as “handlebody-cli compare --csv” writes</source>
        <translation>Dieselbe Tabelle, die „handlebody-cli compare --csv“ schreibt</translation>
    </message>
    <message>
        <source>Save as JSON…</source>
        <translation>Als JSON speichern…</translation>
    </message>
    <message>
        <source>The same as “handlebody-cli compare --report” writes</source>
        <translation>Dasselbe, was „handlebody-cli compare --report“ schreibt</translation>
    </message>
    <message>
        <source>The reference</source>
        <translation>Die Referenz</translation>
    </message>
    <message>
        <source>State of the comparison</source>
        <translation>Stand des Vergleichs</translation>
    </message>
    <message>
        <source>all but 0</source>
        <translation>alle außer 0</translation>
    </message>
    <message>
        <source>Which voxels of a label map are the reference</source>
        <translation>Welche Voxel einer Labelkarte die Referenz sind</translation>
    </message>
    <message>
        <source>Distances in colour on the surface</source>
        <translation>Abstände farbig auf der Oberfläche</translation>
    </message>
    <message>
        <source>Blue inside of the reference, red outside of it</source>
        <translation>Blau innerhalb der Referenz, rot außerhalb</translation>
    </message>
    <message>
        <source>The objects are compared</source>
        <translation>Die Objekte werden verglichen</translation>
    </message>
    <message>
        <source>Choose the reference</source>
        <translation>Die Referenz wählen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>No reference is chosen.</source>
        <translation>Es ist keine Referenz gewählt.</translation>
    </message>
    <message>
        <source>There is no surface to compare yet: grow one first.</source>
        <translation>Es gibt noch keine Oberfläche zum Vergleichen: lassen Sie zuerst eine wachsen.</translation>
    </message>
    <message>
        <source>Comparing…</source>
        <translation>Es wird verglichen…</translation>
    </message>
    <message>
        <source>These are figures of an earlier surface, or of another object.</source>
        <translation>Dies sind Kennzahlen einer früheren Oberfläche oder eines anderen Objekts.</translation>
    </message>
    <message>
        <source>A mesh, a label map or another object to compare the active object with</source>
        <translation>Ein Netz, eine Labelkarte oder ein anderes Objekt, mit dem das aktive Objekt verglichen wird</translation>
    </message>
    <message>
        <source>Save distances…</source>
        <translation>Abstände speichern…</translation>
    </message>
    <message>
        <source>The surface with its distance from the reference at every vertex, as “handlebody-cli compare -o” writes it</source>
        <translation>Die Oberfläche mit ihrem Abstand von der Referenz an jedem Eckpunkt, wie „handlebody-cli compare -o“ sie schreibt</translation>
    </message>
    <message>
        <source>Why no labels are listed</source>
        <translation>Warum keine Labels aufgeführt sind</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Label</translation>
    </message>
    <message>
        <source>Label of the reference</source>
        <translation>Label der Referenz</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>Aus einer Datei…</translation>
    </message>
    <message>
        <source>Save the distances</source>
        <translation>Die Abstände speichern</translation>
    </message>
    <message>
        <source>Meshes and label maps (*.stl *.vtp *.ply *.obj *.3mf *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.dcm);;All files (*)</source>
        <translation>Netze und Labelkarten (*.stl *.vtp *.ply *.obj *.3mf *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.dcm);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::Document</name>
    <message>
        <source>“%1” is locked: unlock it to change it.</source>
        <translation>„%1“ ist gesperrt: entsperren Sie es, um es zu ändern.</translation>
    </message>
    <message>
        <source>Add click outside</source>
        <translation>Außenpunkt setzen</translation>
    </message>
    <message>
        <source>Add seed</source>
        <translation>Startpunkt setzen</translation>
    </message>
    <message>
        <source>Delete click outside</source>
        <translation>Außenpunkt löschen</translation>
    </message>
    <message>
        <source>Delete seed</source>
        <translation>Startpunkt löschen</translation>
    </message>
    <message>
        <source>Move click outside</source>
        <translation>Außenpunkt verschieben</translation>
    </message>
    <message>
        <source>Move seed</source>
        <translation>Startpunkt verschieben</translation>
    </message>
    <message>
        <source>Change radius of click outside</source>
        <translation>Radius des Außenpunkts ändern</translation>
    </message>
    <message>
        <source>Change seed radius</source>
        <translation>Radius des Startpunkts ändern</translation>
    </message>
    <message>
        <source>Smaller object</source>
        <translation>Kleineres Objekt</translation>
    </message>
    <message>
        <source>Larger object</source>
        <translation>Größeres Objekt</translation>
    </message>
    <message>
        <source>The wall would lie outside of the volume: it is not kept.</source>
        <translation>Die Wand läge außerhalb des Bildvolumens: sie wird nicht behalten.</translation>
    </message>
    <message>
        <source>The wall would lie over the seed at %1 mm: it is not kept.</source>
        <translation>Die Wand läge über dem Startpunkt bei %1 mm: sie wird nicht behalten.</translation>
    </message>
    <message>
        <source>Paint wall</source>
        <translation>Wand malen</translation>
    </message>
    <message>
        <source>Erase wall</source>
        <translation>Wand radieren</translation>
    </message>
    <message>
        <source>The surface has not come to rest yet: nothing is pinned.</source>
        <translation>Die Oberfläche ist noch nicht zur Ruhe gekommen: nichts wird fixiert.</translation>
    </message>
    <message>
        <source>Pin here</source>
        <translation>Hier fixieren</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Fixieren</translation>
    </message>
    <message>
        <source>This part of the surface is pinned already.</source>
        <translation>Dieser Teil der Oberfläche ist schon fixiert.</translation>
    </message>
    <message>
        <source>No vertex of the surface lies within %1 mm of %2 mm: nothing is pinned.</source>
        <translation>Im Umkreis von %1 mm um %2 mm liegt keine Ecke der Oberfläche: nichts wird fixiert.</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Keep apart</source>
        <translation>Getrennt halten</translation>
    </message>
    <message>
        <source>Keep as it is</source>
        <translation>So lassen</translation>
    </message>
    <message>
        <source>Wall here</source>
        <translation>Wand hier</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>Zulassen</translation>
    </message>
    <message>
        <source>Remove component</source>
        <translation>Komponente entfernen</translation>
    </message>
    <message>
        <source>Keep only one component</source>
        <translation>Nur eine Komponente behalten</translation>
    </message>
    <message>
        <source>Fill cavity</source>
        <translation>Hohlraum füllen</translation>
    </message>
    <message>
        <source>Smooth here</source>
        <translation>Hier glätten</translation>
    </message>
    <message>
        <source>Pull here</source>
        <translation>Hierher ziehen</translation>
    </message>
    <message>
        <source>Cut here</source>
        <translation>Hier schneiden</translation>
    </message>
    <message>
        <source>Cut handle</source>
        <translation>Henkel durchschneiden</translation>
    </message>
    <message>
        <source>Fill tunnel</source>
        <translation>Tunnel füllen</translation>
    </message>
    <message>
        <source>Close tunnel</source>
        <translation>Tunnel schließen</translation>
    </message>
    <message>
        <source>Leave out an edit</source>
        <translation>Bearbeitung auslassen</translation>
    </message>
    <message>
        <source>Object %1</source>
        <translation>Objekt %1</translation>
    </message>
    <message>
        <source>Add object</source>
        <translation>Objekt hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate object</source>
        <translation>Objekt duplizieren</translation>
    </message>
    <message>
        <source>“%1” is locked: unlock it first.</source>
        <translation>„%1“ ist gesperrt: entsperren Sie es zuerst.</translation>
    </message>
    <message>
        <source>Delete object</source>
        <translation>Objekt löschen</translation>
    </message>
    <message>
        <source>Move object in the list</source>
        <translation>Objekt in der Liste verschieben</translation>
    </message>
    <message>
        <source>Another object is called “%1”.</source>
        <translation>Ein anderes Objekt heißt „%1“.</translation>
    </message>
    <message>
        <source>“%1” has the label value %2.</source>
        <translation>„%1“ hat den Labelwert %2.</translation>
    </message>
    <message>
        <source>Show object</source>
        <translation>Objekt zeigen</translation>
    </message>
    <message>
        <source>Hide object</source>
        <translation>Objekt ausblenden</translation>
    </message>
    <message>
        <source>Lock object</source>
        <translation>Objekt sperren</translation>
    </message>
    <message>
        <source>Unlock object</source>
        <translation>Objekt entsperren</translation>
    </message>
    <message>
        <source>“%1” meets “%2”, and nothing was written: grow it anew, so that it keeps clear.</source>
        <translation>„%1“ trifft auf „%2“, und nichts wurde geschrieben: lassen Sie es neu wachsen, damit es Abstand hält.</translation>
    </message>
    <message>
        <source>There is no surface to export yet: grow one first.</source>
        <translation>Es gibt noch keine Oberfläche zum Exportieren: lassen Sie zuerst eine wachsen.</translation>
    </message>
    <message>
        <source>Nothing is left of the surface at this iteration: step back to one that has some.</source>
        <translation>Bei dieser Iteration ist von der Oberfläche nichts übrig: gehen Sie zu einer zurück, bei der es etwas gibt.</translation>
    </message>
    <message>
        <source>There is no surface to report on yet: grow one first.</source>
        <translation>Es gibt noch keine Oberfläche, über die zu berichten wäre: lassen Sie zuerst eine wachsen.</translation>
    </message>
    <message>
        <source>There is nothing to save yet: open a volume first.</source>
        <translation>Es gibt noch nichts zu speichern: öffnen Sie zuerst ein Bildvolumen.</translation>
    </message>
    <message>
        <source>A session needs a seed: place one inside the object first.</source>
        <translation>Eine Sitzung braucht einen Startpunkt: setzen Sie zuerst einen ins Objekt.</translation>
    </message>
    <message>
        <source>There is no seed yet: place one inside the object first.</source>
        <translation>Es gibt noch keinen Startpunkt: setzen Sie zuerst einen ins Objekt.</translation>
    </message>
    <message>
        <source>Hold it</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>The volume has one time point only.</source>
        <translation>Das Bildvolumen hat nur einen Zeitpunkt.</translation>
    </message>
    <message>
        <source>Frame %1 is being corrected: end that first.</source>
        <translation>Bild %1 wird korrigiert: Beenden Sie das zuerst.</translation>
    </message>
    <message>
        <source>In this frame the surface is grown: change it there as ever.</source>
        <translation>In diesem Bild ist die Oberfläche gewachsen: Ändern Sie sie dort wie gewohnt.</translation>
    </message>
    <message>
        <source>The surface is being carried: wait until that is done, or cancel it.</source>
        <translation>Die Oberfläche wird übertragen: Warten Sie, bis das fertig ist, oder brechen Sie ab.</translation>
    </message>
    <message>
        <source>The surface has not been carried to this frame yet.</source>
        <translation>Die Oberfläche wurde noch nicht in dieses Bild übertragen.</translation>
    </message>
    <message>
        <source>The correction has no surface at rest yet: let it grow, or pause it.</source>
        <translation>Die Korrektur hat noch keine ruhende Oberfläche: Lassen Sie sie wachsen oder halten Sie an.</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Wände</translation>
    </message>
    <message>
        <source>Wall disc</source>
        <translation>Wandscheibe</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>Fixierungen</translation>
    </message>
    <message>
        <source>Veto</source>
        <translation>Veto</translation>
    </message>
    <message>
        <source>Edit by hand</source>
        <translation>Bearbeitung von Hand</translation>
    </message>
    <message>
        <source>Limits of the topology</source>
        <translation>Grenzen der Topologie</translation>
    </message>
    <message>
        <source>Decided: let it happen</source>
        <translation>Entschieden: zulassen</translation>
    </message>
    <message>
        <source>Decided: hold it</source>
        <translation>Entschieden: halten</translation>
    </message>
    <message>
        <source>Clicks</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>A frame is being corrected: end that first.</source>
        <translation>Ein Bild wird korrigiert: Beenden Sie das zuerst.</translation>
    </message>
    <message>
        <source>Open object</source>
        <translation>Objekt öffnen</translation>
    </message>
    <message>
        <source>Open objects</source>
        <translation>Objekte öffnen</translation>
    </message>
    <message>
        <source>Frame %1 is shown, and the surface is grown in frame %2: go there to change it.</source>
        <translation>Bild %1 ist zu sehen, und die Oberfläche ist in Bild %2 gewachsen: Gehen Sie dorthin, um sie zu ändern.</translation>
    </message>
    <message>
        <source>Grow in frame %1</source>
        <translation>In Bild %1 wachsen</translation>
    </message>
    <message>
        <source>Several objects are not carried over time: open the volume with one of them.</source>
        <translation>Mehrere Objekte werden nicht über die Zeit getragen: Öffnen Sie das Bildvolumen mit einem von ihnen.</translation>
    </message>
    <message>
        <source>The surface still grows: wait until it is at rest.</source>
        <translation>Die Oberfläche wächst noch: Warten Sie, bis sie ruht.</translation>
    </message>
    <message>
        <source>There is no surface yet: grow one in a frame first.</source>
        <translation>Es gibt noch keine Oberfläche: Lassen Sie zuerst in einem Bild eine wachsen.</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>Über die Zeit</translation>
    </message>
    <message>
        <source>There are no surfaces over time of what is shown: carry it through the frames first.</source>
        <translation>Zu dem, was gezeigt wird, gibt es keine Oberflächen über die Zeit: Tragen Sie es zuerst durch die Bilder.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>There is no surface yet: grow one first.</source>
        <translation>Es gibt noch keine Oberfläche: lassen Sie zuerst eine wachsen.</translation>
    </message>
    <message>
        <source>It is told of the frame that the surface is grown in: go there first.</source>
        <translation>Das gilt für das Bild, in dem die Oberfläche gewachsen ist: Gehen Sie zuerst dorthin.</translation>
    </message>
    <message>
        <source>It is told of a surface that has come to rest: let it grow to its end first.</source>
        <translation>Das gilt für eine ruhende Oberfläche: Lassen Sie sie zuerst zu Ende wachsen.</translation>
    </message>
    <message>
        <source>polished: %1 bad places, now %2; least angle %3°, was %4°.</source>
        <translation>verbessert: %1 schlechte Stellen, jetzt %2; kleinster Winkel %3°, vorher %4°.</translation>
    </message>
    <message>
        <source>“%1” %2</source>
        <translation>„%1“ %2</translation>
    </message>
    <message>
        <source>A surface that comes from a file is not carried over time: grow one from a click.</source>
        <translation>Eine Oberfläche aus einer Datei wird nicht durch die Zeit getragen: Lassen Sie eine aus einem Klick wachsen.</translation>
    </message>
    <message>
        <source>The name is empty.</source>
        <translation>Der Name ist leer.</translation>
    </message>
    <message>
        <source>The name “%1” is not UTF-8.</source>
        <translation>Der Name „%1“ ist kein UTF-8.</translation>
    </message>
    <message>
        <source>The name “%1” has more than %2 characters.</source>
        <translation>Der Name „%1“ hat mehr als %2 Zeichen.</translation>
    </message>
    <message>
        <source>The name “%1” holds a control character.</source>
        <translation>Der Name „%1“ enthält ein Steuerzeichen.</translation>
    </message>
    <message>
        <source>The name “%1” holds %2, which separates in some of the formats.</source>
        <translation>Der Name „%1“ enthält %2, das in manchen Formaten trennt.</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>%1 cannot be written: it would be a part of the volume that is open. Choose another folder or name.</source>
        <translation>%1 kann nicht geschrieben werden: es wäre ein Teil des geöffneten Volumens. Wählen Sie einen anderen Ordner oder Namen.</translation>
    </message>
    <message>
        <source>A session keeps work over time of one object only: save this one, then open the volume anew to have several objects.</source>
        <translation>Eine Sitzung behält Arbeit über die Zeit nur von einem Objekt: speichern Sie diese, und öffnen Sie dann das Volumen neu, um mehrere Objekte zu haben.</translation>
    </message>
    <message>
        <source>“%1” still grows: wait until it is at rest, or pause it.</source>
        <translation>„%1“ wächst noch: warten Sie, bis es ruht, oder halten Sie es an.</translation>
    </message>
    <message>
        <source>%1 cannot be written: the open work is read from it. Choose another folder or name.</source>
        <translation>%1 kann nicht geschrieben werden: die offene Arbeit wird daraus gelesen. Wählen Sie einen anderen Ordner oder Namen.</translation>
    </message>
    <message>
        <source>Work over time is left out while there are several objects: delete all but one to keep it.</source>
        <translation>Arbeit über die Zeit wird ausgelassen, solange es mehrere Objekte gibt: löschen Sie alle bis auf eines, um sie zu behalten.</translation>
    </message>
    <message>
        <source>“%1” is locked: unlock it to grow in another frame.</source>
        <translation>„%1“ ist gesperrt: entsperren Sie es, um in einem anderen Bild zu wachsen.</translation>
    </message>
    <message>
        <source>Nothing is kept for the case that the program ends unexpectedly: save the session. %1</source>
        <translation>Für den Fall, dass das Programm unerwartet endet, wird nichts aufbewahrt: Speichern Sie die Sitzung. %1</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Of the frames %1–%2 the surface is in these only: %3. Carry it through all of them first.</source>
        <translation>Von den Bildern %1–%2 hat nur ein Teil die Oberfläche: %3. Tragen Sie sie zuerst durch alle.</translation>
    </message>
    <message>
        <source>Frames %1: %2</source>
        <translation>Bilder %1: %2</translation>
    </message>
    <message>
        <source>The surface is still grown in frame %1: frame %2 was not shown.</source>
        <translation>Die Oberfläche wächst weiterhin in Bild %1: Bild %2 wurde nicht gezeigt.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::EventInspector</name>
    <message>
        <source>Stage 1 of 4: the triangles that run into each other.</source>
        <translation>Stufe 1 von 4: die Dreiecke, die ineinanderlaufen.</translation>
    </message>
    <message>
        <source>Stage 2 of 4: the mesh without them, and the polygons that bound the openings.</source>
        <translation>Stufe 2 von 4: das Netz ohne sie und die Polygone, die die Öffnungen begrenzen.</translation>
    </message>
    <message>
        <source>Stage 3 of 4: the handle, or the caps, that close the openings.</source>
        <translation>Stufe 3 von 4: der Henkel oder die Deckel, die die Öffnungen schließen.</translation>
    </message>
    <message>
        <source>Stage 4 of 4: the mesh with the handle in place.</source>
        <translation>Stufe 4 von 4: das Netz mit dem Henkel darin.</translation>
    </message>
    <message>
        <source>Before stage 2: the edges around them are halved, or the openings would not be bounded by simple polygons.</source>
        <translation>Vor Stufe 2: die Kanten um sie werden halbiert, sonst wären die Öffnungen nicht von einfachen Polygonen begrenzt.</translation>
    </message>
    <message>
        <source>Handle inserted</source>
        <translation>Henkel eingesetzt</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Teilung</translation>
    </message>
    <message>
        <source>Enclosed part cut off</source>
        <translation>Umschlossener Teil abgetrennt</translation>
    </message>
    <message>
        <source>Tunnel closed</source>
        <translation>Tunnel geschlossen</translation>
    </message>
    <message>
        <source>Component deleted</source>
        <translation>Komponente gelöscht</translation>
    </message>
    <message>
        <source>Handle cut</source>
        <translation>Henkel durchschnitten</translation>
    </message>
    <message>
        <source>Component removed</source>
        <translation>Komponente entfernt</translation>
    </message>
    <message>
        <source>Cavity filled</source>
        <translation>Hohlraum gefüllt</translation>
    </message>
    <message>
        <source>Fold smoothed</source>
        <translation>Falte geglättet</translation>
    </message>
    <message>
        <source>Cut by a plane</source>
        <translation>Mit einer Ebene geschnitten</translation>
    </message>
    <message>
        <source>Smoothed by hand</source>
        <translation>Von Hand geglättet</translation>
    </message>
    <message>
        <source>Pulled</source>
        <translation>Gezogen</translation>
    </message>
    <message>
        <source>Rolled back</source>
        <translation>Zurückgenommen</translation>
    </message>
    <message>
        <source>Held: %1</source>
        <translation>Gehalten: %1</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Collide</source>
        <translation>Treffen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>Henkel</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zu</translation>
    </message>
    <message>
        <source>Show the whole surface</source>
        <translation>Die ganze Oberfläche zeigen</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>Verfeinern</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Event: %1</source>
        <translation>Ereignis: %1</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>bei %1</translation>
    </message>
    <message>
        <source>Genus %1, components %2</source>
        <translation>Geschlecht %1, Komponenten %2</translation>
    </message>
    <message>
        <source>Edit by hand: %1 → %2</source>
        <translation>Bearbeitung von Hand: %1 → %2</translation>
    </message>
    <message>
        <source>Loop of %1</source>
        <translation>Schleife von %1</translation>
    </message>
    <message>
        <source>Fronts joined: %1</source>
        <translation>Verbundene Fronten: %1</translation>
    </message>
    <message>
        <source>Boundary polygons of %1 vertices</source>
        <translation>Randpolygone mit %1 Ecken</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>Zulassen</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>Keep apart here</source>
        <translation>Hier getrennt halten</translation>
    </message>
    <message>
        <source>Goes back to the step before this edit, and on without it</source>
        <translation>Geht zurück zum Schritt vor dieser Bearbeitung und ohne sie weiter</translation>
    </message>
    <message>
        <source>Goes back to the step before; grown on from there, this does not happen</source>
        <translation>Geht zurück zum Schritt davor; von dort weitergewachsen, geschieht dies nicht</translation>
    </message>
    <message>
        <source>From the shown step on, what is held here may happen</source>
        <translation>Ab dem gezeigten Schritt darf geschehen, was hier gehalten wird</translation>
    </message>
    <message>
        <source>The step is worked out again…</source>
        <translation>Der Schritt wird noch einmal berechnet…</translation>
    </message>
    <message>
        <source>The mesh was not opened here: there are no stages to show.</source>
        <translation>Das Netz wurde hier nicht geöffnet: es gibt keine Stufen zu zeigen.</translation>
    </message>
    <message>
        <source>Nothing was refined here: the polygons were simple.</source>
        <translation>Hier wurde nichts verfeinert: die Polygone waren einfach.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::EventTable</name>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>Place (LPS)</source>
        <translation>Ort (LPS)</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>Geschlecht</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ExportPanel</name>
    <message>
        <source>Surface or label map</source>
        <translation>Oberfläche oder Labelkarte</translation>
    </message>
    <message>
        <source>Nothing has grown yet. Place a seed and start the growth first.</source>
        <translation>Noch ist nichts gewachsen. Setzen Sie zuerst einen Startpunkt und starten Sie das Wachstum.</translation>
    </message>
    <message>
        <source>All objects in one file</source>
        <translation>Alle Objekte in einer Datei</translation>
    </message>
    <message>
        <source>The active object</source>
        <translation>Das aktive Objekt</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objekte</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>A surface keeps all detail; a label map has the voxels of the volume</source>
        <translation>Eine Oberfläche behält alle Einzelheiten; eine Labelkarte hat die Voxel des Bildvolumens</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Koordinaten</translation>
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
        <translation>x zur linken Seite des Patienten, y nach hinten, wie in DICOM und ITK</translation>
    </message>
    <message>
        <source>x to the patient's right, y to the front, as in NIfTI and 3D Slicer</source>
        <translation>x zur rechten Seite des Patienten, y nach vorn, wie in NIfTI und 3D Slicer</translation>
    </message>
    <message>
        <source>Why nothing is written</source>
        <translation>Warum nichts geschrieben wird</translation>
    </message>
    <message>
        <source>What is written</source>
        <translation>Was geschrieben wird</translation>
    </message>
    <message>
        <source>STL surface, binary</source>
        <translation>STL-Oberfläche, binär</translation>
    </message>
    <message>
        <source>VTP surface (VTK)</source>
        <translation>VTP-Oberfläche (VTK)</translation>
    </message>
    <message>
        <source>PLY surface, binary</source>
        <translation>PLY-Oberfläche, binär</translation>
    </message>
    <message>
        <source>OBJ surface</source>
        <translation>OBJ-Oberfläche</translation>
    </message>
    <message>
        <source>3MF surface, to print</source>
        <translation>3MF-Oberfläche zum Drucken</translation>
    </message>
    <message>
        <source>NIfTI label map</source>
        <translation>NIfTI-Labelkarte</translation>
    </message>
    <message>
        <source>NRRD label map</source>
        <translation>NRRD-Labelkarte</translation>
    </message>
    <message>
        <source>MetaImage label map</source>
        <translation>MetaImage-Labelkarte</translation>
    </message>
    <message>
        <source>3D Slicer segmentation</source>
        <translation>3D-Slicer-Segmentierung</translation>
    </message>
    <message>
        <source>DICOM segmentation</source>
        <translation>DICOM-Segmentierung</translation>
    </message>
    <message>
        <source>DICOM with STL surface</source>
        <translation>DICOM mit STL-Oberfläche</translation>
    </message>
    <message>
        <source>Gmsh tetrahedra</source>
        <translation>Gmsh-Tetraeder</translation>
    </message>
    <message>
        <source>VTK tetrahedra</source>
        <translation>VTK-Tetraeder</translation>
    </message>
    <message>
        <source>Abaqus tetrahedra</source>
        <translation>Abaqus-Tetraeder</translation>
    </message>
    <message>
        <source>Without what names the patient</source>
        <translation>Ohne Angaben zum Patienten</translation>
    </message>
    <message>
        <source>What is being written</source>
        <translation>Was gerade geschrieben wird</translation>
    </message>
    <message>
        <source>A file is being written</source>
        <translation>Eine Datei wird geschrieben</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel writing</source>
        <translation>Schreiben abbrechen</translation>
    </message>
    <message>
        <source>Writing %1…</source>
        <translation>%1 wird geschrieben…</translation>
    </message>
    <message>
        <source>It was cancelled: nothing was written.</source>
        <translation>Abgebrochen: nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>All four views</source>
        <translation>Alle vier Ansichten</translation>
    </message>
    <message>
        <source>%1 view</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>Picture of</source>
        <translation>Bild von</translation>
    </message>
    <message>
        <source>Which view is written as PNG</source>
        <translation>Welche Ansicht als PNG geschrieben wird</translation>
    </message>
    <message>
        <source>Report and session</source>
        <translation>Bericht und Sitzung</translation>
    </message>
    <message>
        <source>The report holds every parameter, number and event. A session opens here again, and “handlebody-cli replay” makes the same mesh of it.</source>
        <translation>Der Bericht enthält alle Parameter, Zahlen und Ereignisse. Eine Sitzung öffnet sich hier wieder, und „handlebody-cli replay“ macht daraus dasselbe Netz.</translation>
    </message>
    <message>
        <source>Objects: %1; %2 together.</source>
        <translation>Objekte: %1; zusammen %2.</translation>
    </message>
    <message>
        <source>Without a surface: %1.</source>
        <translation>Ohne Oberfläche: %1.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Made with earlier surfaces: %1. Nothing is written if any of them meet.</source>
        <translation>Mit früheren Oberflächen gemacht: %1. Nichts wird geschrieben, wenn sich welche treffen.</translation>
    </message>
    <message>
        <source>Nothing is left of the surface at this iteration.</source>
        <translation>Bei dieser Iteration ist von der Oberfläche nichts übrig.</translation>
    </message>
    <message>
        <source>Iteration %1: %2, %3</source>
        <translation>Iteration %1: %2, %3</translation>
    </message>
    <message>
        <source>What was bettered</source>
        <translation>Was verbessert wurde</translation>
    </message>
    <message>
        <source>glTF scene, to view</source>
        <translation>glTF-Szene, zum Ansehen</translation>
    </message>
    <message>
        <source>Better thin triangles</source>
        <translation>Dünne Dreiecke verbessern</translation>
    </message>
    <message>
        <source>Triangles with an angle under 15° and edges sharper than 20°, which a solver cannot use, are made better in what is written; the surface goes no farther than a tenth of a voxel. The session keeps this choice.</source>
        <translation>Dreiecke mit einem Winkel unter 15° und Kanten schärfer als 20°, die ein Löser nicht brauchen kann, werden beim Schreiben verbessert; die Oberfläche bewegt sich höchstens um ein Zehntel Voxel. Die Sitzung merkt sich diese Wahl.</translation>
    </message>
    <message>
        <source>Bettering the triangles of “%1”…</source>
        <translation>Dreiecke von „%1“ werden verbessert…</translation>
    </message>
    <message>
        <source>Bettering the triangles…</source>
        <translation>Dreiecke werden verbessert…</translation>
    </message>
    <message>
        <source>Creator</source>
        <translation>Ersteller</translation>
    </message>
    <message>
        <source>Who made it, as DICOM writes names: Family^Given. May stay empty</source>
        <translation>Wer es gemacht hat, wie DICOM Namen schreibt: Nachname^Vorname. Darf leer bleiben</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>What it is for. May stay empty</source>
        <translation>Wofür es ist. Darf leer bleiben</translation>
    </message>
    <message>
        <source>ITK-SNAP label description</source>
        <translation>Labelbeschreibung für ITK-SNAP</translation>
    </message>
    <message>
        <source>DICOM files, report and measures are written without patient, study, dates and names of files, and the names that are suggested do not tell the volume's. In place of saving the session one is exported that does not say where its volume is: it asks for it when it is opened.</source>
        <translation>DICOM-Dateien, Bericht und Maße werden ohne Patient, Studie, Daten und Dateinamen geschrieben, und die vorgeschlagenen Namen verraten nicht den des Volumens. Statt die Sitzung zu speichern, wird eine exportiert, die nicht sagt, wo ihr Volumen liegt: Beim Öffnen fragt sie danach.</translation>
    </message>
    <message>
        <source>Each object in a file of its own</source>
        <translation>Jedes Objekt in einer eigenen Datei</translation>
    </message>
    <message>
        <source>What a file holds: names and colours stay apart where it can; to the name of a file of one object its name is added</source>
        <translation>Was eine Datei enthält: Namen und Farben bleiben getrennt, wo sie es kann; an den Namen der Datei eines Objekts wird dessen Name angehängt</translation>
    </message>
    <message>
        <source>Nothing is left of the file, nor of those that wait</source>
        <translation>Von der Datei bleibt nichts übrig, auch nicht von denen, die warten</translation>
    </message>
    <message>
        <source>Waiting: %1.</source>
        <translation>Es warten: %1.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::FileWork</name>
    <message>
        <source>%1 is written.</source>
        <translation>%1 ist geschrieben.</translation>
    </message>
    <message>
        <source>The session is saved as %1.</source>
        <translation>Die Sitzung ist als %1 gespeichert.</translation>
    </message>
    <message>
        <source>A replay grows anew: %1.</source>
        <translation>Eine Wiederholung lässt neu wachsen: %1.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Open a volume or a session</source>
        <translation>Ein Bildvolumen oder eine Sitzung öffnen</translation>
    </message>
    <message>
        <source>Open a folder with a DICOM series</source>
        <translation>Einen Ordner mit einer DICOM-Serie öffnen</translation>
    </message>
    <message>
        <source>Enter the spacing</source>
        <translation>Abstand eingeben</translation>
    </message>
    <message>
        <source>The sample is not installed with this program.</source>
        <translation>Das Beispiel ist mit diesem Programm nicht installiert.</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Ungespeicherte Arbeit</translation>
    </message>
    <message>
        <source>Save the seeds and parameters first?</source>
        <translation>Zuerst Startpunkte und Parameter speichern?</translation>
    </message>
    <message>
        <source>They are kept in a session, from which the same surface can be grown again.</source>
        <translation>Sie stehen in einer Sitzung, aus der dieselbe Oberfläche wieder wachsen kann.</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Die Sitzung speichern</translation>
    </message>
    <message>
        <source>Sessions (*.json)</source>
        <translation>Sitzungen (*.json)</translation>
    </message>
    <message>
        <source>Export the result</source>
        <translation>Das Ergebnis exportieren</translation>
    </message>
    <message>
        <source>Export the report</source>
        <translation>Den Bericht exportieren</translation>
    </message>
    <message>
        <source>Export a picture</source>
        <translation>Ein Bild exportieren</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>%1 kann nicht geschrieben werden: %2.</translation>
    </message>
    <message>
        <source>The program ended unexpectedly last time. Its seeds and parameters were kept.</source>
        <translation>Das Programm endete beim letzten Mal unerwartet. Seine Startpunkte und Parameter wurden aufbewahrt.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Volumes and sessions (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.tif *.tiff *.dcm *.json);;All files (*)</source>
        <translation>Bildvolumen und Sitzungen (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.tif *.tiff *.dcm *.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a mesh or a label map</source>
        <translation>Ein Netz oder eine Labelkarte öffnen</translation>
    </message>
    <message>
        <source>Open objects</source>
        <translation>Objekte öffnen</translation>
    </message>
    <message>
        <source>Making surfaces of %1…</source>
        <translation>Oberflächen von %1 entstehen…</translation>
    </message>
    <message>
        <source>%1 is open as: %2.</source>
        <translation>%1 ist offen als: %2.</translation>
    </message>
    <message>
        <source>%1 is a surface: open the volume first that it lies in.</source>
        <translation>%1 ist eine Oberfläche: Öffnen Sie zuerst das Bildvolumen, in dem sie liegt.</translation>
    </message>
    <message>
        <source>Export a 4D label map</source>
        <translation>Eine 4D-Labelkarte exportieren</translation>
    </message>
    <message>
        <source>Export the meshes of all frames</source>
        <translation>Die Netze aller Bilder exportieren</translation>
    </message>
    <message>
        <source>Choose the file…</source>
        <translation>Datei auswählen…</translation>
    </message>
    <message>
        <source>Choose the folder…</source>
        <translation>Ordner auswählen…</translation>
    </message>
    <message>
        <source>Choose what the session needs</source>
        <translation>Auswählen, was die Sitzung braucht</translation>
    </message>
    <message>
        <source>Export an anonymous session</source>
        <translation>Anonyme Sitzung exportieren</translation>
    </message>
    <message>
        <source>Segments overlap: what several of them hold is left to the smallest (voxels: %1). Step 4, Grow, tells it of each.</source>
        <translation>Segmente überlappen sich: Was mehrere von ihnen enthalten, bleibt dem kleinsten (Voxel: %1). Schritt 4, Wachsen, sagt es von jedem.</translation>
    </message>
    <message>
        <source>Meshes and label maps (*.stl *.vtp *.ply *.obj *.3mf *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.dcm);;All files (*)</source>
        <translation>Netze und Labelkarten (*.stl *.vtp *.ply *.obj *.3mf *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.dcm);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>There already: %1. Replace what is there?</source>
        <translation>Schon vorhanden: %1. Ersetzen, was da ist?</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 weitere</translation>
    </message>
    <message>
        <source>A file is being written. The window closes when it is done.</source>
        <translation>Eine Datei wird gerade geschrieben. Das Fenster schließt sich, wenn sie fertig ist.</translation>
    </message>
    <message>
        <source>Stay open</source>
        <translation>Offen bleiben</translation>
    </message>
    <message>
        <source>%1 was changed elsewhere since it was opened or saved here. Replace what is there?</source>
        <translation>%1 wurde anderswo geändert, seit die Datei hier geöffnet oder gespeichert wurde. Ersetzen, was dort steht?</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Überschreiben</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::FrameSlider</name>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>&lt;p&gt;Time: the frames of the volume. A ring is the frame the surface is grown in, dots are frames it was carried to: orange with a warning, red where it failed. Click or drag to go there.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Zeit: die Bilder des Bildvolumens. Ein Ring ist das Bild, in dem die Oberfläche gewachsen ist, Punkte sind Bilder, in die sie übertragen wurde: orange mit einer Warnung, rot, wo es misslang. Klicken oder ziehen, um dorthin zu gehen.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::GrowPanel</name>
    <message>
        <source>not closed</source>
        <translation>nicht geschlossen</translation>
    </message>
    <message>
        <source>not manifold</source>
        <translation>nicht mannigfaltig</translation>
    </message>
    <message>
        <source>not oriented</source>
        <translation>nicht orientiert</translation>
    </message>
    <message>
        <source>self-intersections: %1</source>
        <translation>Selbstschnitte: %1</translation>
    </message>
    <message>
        <source>parts that lie wrongly in each other: %1</source>
        <translation>Teile, die falsch ineinander liegen: %1</translation>
    </message>
    <message>
        <source>self-intersections not checked</source>
        <translation>Selbstschnitte nicht geprüft</translation>
    </message>
    <message>
        <source>Finished: the surface is at rest</source>
        <translation>Fertig: die Oberfläche ruht</translation>
    </message>
    <message>
        <source>Stopped at the iteration limit</source>
        <translation>An der Iterationsgrenze angehalten</translation>
    </message>
    <message>
        <source>Finished: nothing is left of the surface</source>
        <translation>Fertig: von der Oberfläche ist nichts übrig</translation>
    </message>
    <message>
        <source>At rest, but parts that could not be mended would still move</source>
        <translation>Ruht, aber Teile, die nicht in Ordnung zu bringen waren, würden sich noch bewegen</translation>
    </message>
    <message>
        <source>Stuck: no part of a step could be kept</source>
        <translation>Steckt fest: kein Teil eines Schritts konnte beibehalten werden</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>⚠ Worth a look</source>
        <translation>⚠ Bitte ansehen</translation>
    </message>
    <message>
        <source>iteration %1 of %2</source>
        <translation>Iteration %1 von %2</translation>
    </message>
    <message>
        <source>Preparing the image…</source>
        <translation>Das Bild wird vorbereitet…</translation>
    </message>
    <message>
        <source>Growing</source>
        <translation>Wächst</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>No seed yet</source>
        <translation>Noch kein Startpunkt</translation>
    </message>
    <message>
        <source>Ready to grow</source>
        <translation>Bereit zu wachsen</translation>
    </message>
    <message>
        <source>Nothing grew</source>
        <translation>Nichts ist gewachsen</translation>
    </message>
    <message>
        <source>These clicks mean another object: begun anew at iteration %1</source>
        <translation>Diese Punkte meinen ein anderes Objekt: bei Iteration %1 neu begonnen</translation>
    </message>
    <message>
        <source>Clicks changed at iteration %1: gone on from there</source>
        <translation>Punkte bei Iteration %1 geändert: von dort weiter</translation>
    </message>
    <message>
        <source>Start grows the surface from the seeds. You may pause, go back exactly, change a click or a parameter and go on from there at any time.</source>
        <translation>Start lässt die Oberfläche von den Startpunkten aus wachsen. Sie können jederzeit anhalten, genau zurückgehen, einen Punkt oder Parameter ändern und von dort weitermachen.</translation>
    </message>
    <message>
        <source>State of the growth</source>
        <translation>Stand des Wachstums</translation>
    </message>
    <message>
        <source>Why it did not grow</source>
        <translation>Warum es nicht wuchs</translation>
    </message>
    <message>
        <source>Doubts about the surface</source>
        <translation>Zweifel an der Oberfläche</translation>
    </message>
    <message>
        <source>Steps per frame</source>
        <translation>Schritte je Bild</translation>
    </message>
    <message>
        <source>How many iterations the surface goes on between two pictures of it</source>
        <translation>Wie viele Iterationen die Oberfläche zwischen zwei Bildern weitergeht</translation>
    </message>
    <message>
        <source>Pause at a leak</source>
        <translation>Bei einem Leck anhalten</translation>
    </message>
    <message>
        <source>The growth pauses where the surface has come through a passage much narrower than what lies on both sides of it</source>
        <translation>Das Wachstum hält an, wo die Oberfläche durch einen Durchgang kam, der viel enger ist als das, was auf beiden Seiten liegt</translation>
    </message>
    <message>
        <source>Surface now</source>
        <translation>Oberfläche jetzt</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Zertifikat</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Volume enclosed by the surface</source>
        <translation>Von der Oberfläche umschlossenes Volumen</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Area of the surface</source>
        <translation>Flächeninhalt der Oberfläche</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Komponenten</translation>
    </message>
    <message>
        <source>Connected parts of the surface</source>
        <translation>Zusammenhängende Teile der Oberfläche</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>Geschlecht</translation>
    </message>
    <message>
        <source>Holes as in a ring: in all, and of each component</source>
        <translation>Löcher wie in einem Ring: insgesamt und je Komponente</translation>
    </message>
    <message>
        <source>Euler number</source>
        <translation>Euler-Zahl</translation>
    </message>
    <message>
        <source>Vertices minus edges plus faces</source>
        <translation>Ecken minus Kanten plus Flächen</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Vertices of the mesh</source>
        <translation>Ecken des Netzes</translation>
    </message>
    <message>
        <source>Nothing is left of the surface</source>
        <translation>Von der Oberfläche ist nichts übrig</translation>
    </message>
    <message>
        <source>✓ Closed, manifold, free of self-intersections</source>
        <translation>✓ Geschlossen, mannigfaltig, ohne Selbstschnitte</translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>As it was opened: nothing grows</source>
        <translation>Wie geöffnet: Nichts wächst</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::HeldSection</name>
    <message>
        <source>What is held back</source>
        <translation>Was gehalten wird</translation>
    </message>
    <message>
        <source>Nothing is held back.</source>
        <translation>Nichts wird gehalten.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Where (mm LPS)</source>
        <translation>Wo (mm LPS)</translation>
    </message>
    <message>
        <source>What is held back, each with its place</source>
        <translation>Was gehalten wird, jeweils mit seinem Ort</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>Aufheben</translation>
    </message>
    <message>
        <source>At most %1 components</source>
        <translation>Höchstens %1 Komponenten</translation>
    </message>
    <message>
        <source>Lift the limit</source>
        <translation>Die Grenze aufheben</translation>
    </message>
    <message>
        <source>Genus at most %1</source>
        <translation>Geschlecht höchstens %1</translation>
    </message>
    <message>
        <source>May break the limits</source>
        <translation>Darf die Grenzen überschreiten</translation>
    </message>
    <message>
        <source>Allow no more</source>
        <translation>Nicht mehr erlauben</translation>
    </message>
    <message>
        <source>Veto at iteration %1</source>
        <translation>Veto bei Iteration %1</translation>
    </message>
    <message>
        <source>Lift the veto</source>
        <translation>Das Veto aufheben</translation>
    </message>
    <message>
        <source>Pin at iteration %1</source>
        <translation>Fixierung bei Iteration %1</translation>
    </message>
    <message>
        <source>%1, %2 balls</source>
        <translation>%1, %2 Kugeln</translation>
    </message>
    <message>
        <source>Lift the pin</source>
        <translation>Die Fixierung aufheben</translation>
    </message>
    <message>
        <source>Disc, radius %1</source>
        <translation>Scheibe, Radius %1</translation>
    </message>
    <message>
        <source>Lift the disc</source>
        <translation>Die Scheibe aufheben</translation>
    </message>
    <message>
        <source>Walls of %1</source>
        <translation>Wände aus %1</translation>
    </message>
    <message>
        <source>Lift the map of walls</source>
        <translation>Die Karte der Wände aufheben</translation>
    </message>
    <message>
        <source>Held: %1</source>
        <translation>Gehalten: %1</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>Zulassen</translation>
    </message>
    <message>
        <source>From the shown iteration on the chosen one holds nothing back</source>
        <translation>Ab der gezeigten Iteration hält das Gewählte nichts mehr</translation>
    </message>
    <message>
        <source>Held, as you decided</source>
        <translation>Gehalten, wie Sie entschieden haben</translation>
    </message>
    <message>
        <source>Decide again</source>
        <translation>Neu entscheiden</translation>
    </message>
    <message>
        <source>To decide: %1</source>
        <translation>Zu entscheiden: %1</translation>
    </message>
    <message>
        <source>%1 around</source>
        <translation>%1 Umfang</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::HelpWindow</name>
    <message>
        <source>Handlebody: help</source>
        <translation>Handlebody: Hilfe</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Anleitung</translation>
    </message>
    <message>
        <source>Keyboard and mouse</source>
        <translation>Tastatur und Maus</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Über</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::HistogramView</name>
    <message>
        <source>Histogram with the object's range</source>
        <translation>Histogramm mit dem Bereich des Objekts</translation>
    </message>
    <message>
        <source>&lt;p&gt;How often each intensity occurs (square root). Drag the ends of the object's range; with the keyboard: Up and Down choose an end, Left and Right move it.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Wie oft jede Intensität vorkommt (Quadratwurzel). Ziehen Sie die Enden des Objektbereichs; mit der Tastatur: Auf und Ab wählen ein Ende, Links und Rechts bewegen es.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>From %1 to %2</source>
        <translation>Von %1 bis %2</translation>
    </message>
    <message>
        <source>No range yet</source>
        <translation>Noch kein Bereich</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::LabelChoice</name>
    <message>
        <source>Label %1</source>
        <translation>Label %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>&amp;Labels to open</source>
        <translation>&amp;Labels, die geöffnet werden</translation>
    </message>
    <message>
        <source>Labels to open</source>
        <translation>Labels, die geöffnet werden</translation>
    </message>
    <message>
        <source>Each that is checked becomes an object, called and coloured as the file says</source>
        <translation>Jedes angekreuzte wird ein Objekt, mit Namen und Farbe aus der Datei</translation>
    </message>
    <message>
        <source>&amp;All</source>
        <translation>&amp;Alle</translation>
    </message>
    <message>
        <source>Checks all labels</source>
        <translation>Kreuzt alle Labels an</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Keines</translation>
    </message>
    <message>
        <source>Checks no label</source>
        <translation>Kreuzt kein Label an</translation>
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
        <translation>Radius am Fadenkreuz</translation>
    </message>
    <message>
        <source>Of the ball in which the surface is pinned or smoothed, and how far along it a pull reaches</source>
        <translation>Der Kugel, in der die Oberfläche fixiert oder geglättet wird, und wie weit ein Zug an ihr entlang reicht</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Fixieren</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Cut as the axial slices lie</source>
        <translation>Schneiden, wie die axialen Schichten liegen</translation>
    </message>
    <message>
        <source>Cut as the coronal slices lie</source>
        <translation>Schneiden, wie die koronalen Schichten liegen</translation>
    </message>
    <message>
        <source>Cut as the sagittal slices lie</source>
        <translation>Schneiden, wie die sagittalen Schichten liegen</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
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
        <translation>Beide Seiten des Schnitts bleiben</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>Posterior</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Anterior</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Keep: %1</source>
        <translation>Behalten: %1</translation>
    </message>
    <message>
        <source>Only what lies on this side of the plane stays</source>
        <translation>Nur was auf dieser Seite der Ebene liegt, bleibt</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::MainWindow</name>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Wände</translation>
    </message>
    <message>
        <source>Paint in the slices where the surface may not go, from the shown iteration on. Ctrl+wheel changes the radius.</source>
        <translation>Malen Sie in den Schichten, wohin die Oberfläche ab der gezeigten Iteration nicht darf. Strg+Mausrad ändert den Radius.</translation>
    </message>
    <message>
        <source>On the surface</source>
        <translation>Auf der Oberfläche</translation>
    </message>
    <message>
        <source>With the brush, in the slices and in 3D: drag to pin or unpin, click to smooth, drag a point to pull it. The radius is the same. A line drawn across it in a slice cuts it.</source>
        <translation>Mit dem Pinsel, in den Schichten und in 3D: ziehen zum Fixieren oder Lösen, klicken zum Glätten, einen Punkt ziehen zum Verformen. Der Radius ist derselbe. Eine Linie quer darüber in einer Schicht schneidet sie.</translation>
    </message>
    <message>
        <source>Held back</source>
        <translation>Gehalten</translation>
    </message>
    <message>
        <source>Limits, vetoes, pins and discs. The crosshair goes to the chosen one; lifted, it holds no more from the shown iteration on.</source>
        <translation>Grenzen, Vetos, Fixierungen und Scheiben. Das Fadenkreuz geht zum Gewählten; aufgehoben, hält es ab der gezeigten Iteration nicht mehr.</translation>
    </message>
    <message>
        <source>At the crosshair</source>
        <translation>Am Fadenkreuz</translation>
    </message>
    <message>
        <source>A pin holds the surface in a ball. To smooth, pull and cut is the next step.</source>
        <translation>Eine Fixierung hält die Oberfläche in einer Kugel. Glätten, Ziehen und Schneiden sind der nächste Schritt.</translation>
    </message>
    <message>
        <source>The surface is pinned here from iteration %1 on.</source>
        <translation>Die Oberfläche ist hier ab Iteration %1 fixiert.</translation>
    </message>
    <message>
        <source>Tunnels and pieces</source>
        <translation>Tunnel und Teile</translation>
    </message>
    <message>
        <source>What the shown surface holds, and what can be done to it: each edit is the next step.</source>
        <translation>Was die gezeigte Oberfläche enthält und was mit ihr getan werden kann: jede Bearbeitung ist der nächste Schritt.</translation>
    </message>
    <message>
        <source>Several files were dropped; the first one is opened. For a DICOM series drop its folder.</source>
        <translation>Mehrere Dateien wurden abgelegt; die erste wird geöffnet. Für eine DICOM-Serie legen Sie ihren Ordner ab.</translation>
    </message>
    <message>
        <source>The language changes when the program is started again.</source>
        <translation>Die Sprache wechselt, wenn das Programm neu gestartet wird.</translation>
    </message>
    <message>
        <source>P&amp;ause</source>
        <translation>An&amp;halten</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Start</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1: %2, was %3.</source>
        <translation>%1: %2, war %3.</translation>
    </message>
    <message>
        <source>A leak at iteration %1: %2.</source>
        <translation>Ein Leck bei Iteration %1: %2.</translation>
    </message>
    <message>
        <source>Wall here</source>
        <translation>Wand hier</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>“%1” came through a narrow passage.</source>
        <translation>„%1“ kam durch einen engen Durchgang.</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>Messwerte</translation>
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
        <translation>Alle Wände entfernen</translation>
    </message>
    <message>
        <source>Remove all pins</source>
        <translation>Alle Fixierungen entfernen</translation>
    </message>
    <message>
        <source>The surface is already where the wall is.</source>
        <translation>Die Oberfläche ist schon dort, wo die Wand ist.</translation>
    </message>
    <message>
        <source>Go back to before it came in here</source>
        <translation>Zurück, bevor sie dorthin kam</translation>
    </message>
    <message>
        <source>Push it out</source>
        <translation>Hinausschieben</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>Zulassen</translation>
    </message>
    <message>
        <source>Hold it</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>“%1” has paused: a change of its topology is held, for you to decide.</source>
        <translation>„%1“ ist angehalten: Eine Änderung der Topologie wird gehalten, bis Sie entscheiden.</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>Über die Zeit</translation>
    </message>
    <message>
        <source>&amp;Stop playing</source>
        <translation>An&amp;halten</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>&amp;Over time</source>
        <translation>Ü&amp;ber die Zeit</translation>
    </message>
    <message>
        <source>These objects lose their surfaces, too, and undo does not bring them back: %1. Grow in this frame?</source>
        <translation>Auch diese Objekte verlieren ihre Oberflächen, und Rückgängig bringt sie nicht zurück: %1. In diesem Bild wachsen?</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Grow in this frame</source>
        <translation>In diesem Bild wachsen</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::Measurements</name>
    <message>
        <source>Ruler %1</source>
        <translation>Lineal %1</translation>
    </message>
    <message>
        <source>Angle %1</source>
        <translation>Winkel %1</translation>
    </message>
    <message>
        <source>Add ruler</source>
        <translation>Lineal hinzufügen</translation>
    </message>
    <message>
        <source>Add angle</source>
        <translation>Winkel hinzufügen</translation>
    </message>
    <message>
        <source>Move ruler</source>
        <translation>Lineal verschieben</translation>
    </message>
    <message>
        <source>Move angle</source>
        <translation>Winkel verschieben</translation>
    </message>
    <message>
        <source>Delete ruler</source>
        <translation>Lineal löschen</translation>
    </message>
    <message>
        <source>Delete angle</source>
        <translation>Winkel löschen</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::MeasuresPanel</name>
    <message>
        <source>What is measured</source>
        <translation>Was gemessen wird</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objekte</translation>
    </message>
    <message>
        <source>Rulers and angles</source>
        <translation>Lineale und Winkel</translation>
    </message>
    <message>
        <source>Centre line</source>
        <translation>Mittellinie</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Empfindlichkeit</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::MessageBar</name>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>Information</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>Die Meldung schließen</translation>
    </message>
    <message>
        <source>Close the message (Esc)</source>
        <translation>Die Meldung schließen (Esc)</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ObjectChoice</name>
    <message>
        <source>The only one: %1</source>
        <translation>Das einzige: %1</translation>
    </message>
    <message>
        <source>%1 of %2 by size: %3</source>
        <translation>%1 von %2 nach Größe: %3</translation>
    </message>
    <message>
        <source>%1 (likeliest)</source>
        <translation>%1 (am wahrscheinlichsten)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Which object is taken</source>
        <translation>Welches Objekt genommen wird</translation>
    </message>
    <message>
        <source>Whether the choice is sure</source>
        <translation>Ob die Wahl sicher ist</translation>
    </message>
    <message>
        <source>A close choice: look at the others, too.</source>
        <translation>Eine knappe Wahl: sehen Sie sich auch die anderen an.</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Kleiner</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Größer</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ObjectDialog</name>
    <message>
        <source>Properties of the object</source>
        <translation>Eigenschaften des Objekts</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What the object is called in the list and in files that hold names</source>
        <translation>Wie das Objekt in der Liste heißt und in Dateien, die Namen enthalten</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Of its surface and outlines, and in files that hold colours</source>
        <translation>Seiner Oberfläche und Umrisse, und in Dateien, die Farben enthalten</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>&amp;Farbe</translation>
    </message>
    <message>
        <source>Term</source>
        <translation>Begriff</translation>
    </message>
    <message>
        <source>What it is, as a code of SNOMED CT; gives the colour, too</source>
        <translation>Was es ist, als Code von SNOMED CT; gibt auch die Farbe</translation>
    </message>
    <message>
        <source>&amp;Term</source>
        <translation>&amp;Begriff</translation>
    </message>
    <message>
        <source>Label value</source>
        <translation>Labelwert</translation>
    </message>
    <message>
        <source>Of its voxels in a label map</source>
        <translation>Seiner Voxel in einer Labelkarte</translation>
    </message>
    <message>
        <source>&amp;Label value</source>
        <translation>&amp;Labelwert</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Was nicht stimmt</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Colour of the object</source>
        <translation>Farbe des Objekts</translation>
    </message>
    <message>
        <source>Change object</source>
        <translation>Objekt ändern</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ObjectMeasuresPage</name>
    <message>
        <source>Measures of the objects</source>
        <translation>Messwerte der Objekte</translation>
    </message>
    <message>
        <source>More about the chosen object</source>
        <translation>Mehr über das gewählte Objekt</translation>
    </message>
    <message>
        <source>State of the measures</source>
        <translation>Stand der Messung</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>Wanddicke</translation>
    </message>
    <message>
        <source>The distance of two surfaces over their area: of two objects, or of an object and its own cavities</source>
        <translation>Der Abstand zweier Oberflächen über ihre Fläche: zweier Objekte oder eines Objekts und seiner Hohlräume</translation>
    </message>
    <message>
        <source>How much is measured</source>
        <translation>Wie viel gemessen ist</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Measure the surfaces as they are shown</source>
        <translation>Die Oberflächen messen, wie sie gezeigt sind</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the table, to paste it into a spreadsheet</source>
        <translation>Die Tabelle kopieren, um sie in eine Tabellenkalkulation einzufügen</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Als CSV speichern…</translation>
    </message>
    <message>
        <source>The same table as “handlebody-cli measure --csv” writes</source>
        <translation>Dieselbe Tabelle, die „handlebody-cli measure --csv“ schreibt</translation>
    </message>
    <message>
        <source>Save as JSON…</source>
        <translation>Als JSON speichern…</translation>
    </message>
    <message>
        <source>The same as “handlebody-cli measure --json” writes</source>
        <translation>Dasselbe, was „handlebody-cli measure --json“ schreibt</translation>
    </message>
    <message>
        <source>Save the measures</source>
        <translation>Die Messwerte speichern</translation>
    </message>
    <message>
        <source>No wall thickness</source>
        <translation>Keine Wanddicke</translation>
    </message>
    <message>
        <source>Wall of “%1” around its cavities</source>
        <translation>Wand von „%1“ um seine Hohlräume</translation>
    </message>
    <message>
        <source>Wall from “%1” to “%2”</source>
        <translation>Wand von „%1“ bis „%2“</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>There is no surface to measure yet: grow one first.</source>
        <translation>Es gibt noch keine Oberfläche zum Messen: lassen Sie zuerst eine wachsen.</translation>
    </message>
    <message>
        <source>Measuring. What is shown is of earlier surfaces.</source>
        <translation>Es wird gemessen. Gezeigt sind Werte früherer Oberflächen.</translation>
    </message>
    <message>
        <source>Measuring.</source>
        <translation>Es wird gemessen.</translation>
    </message>
    <message>
        <source>These are measures of earlier surfaces.</source>
        <translation>Dies sind Messwerte früherer Oberflächen.</translation>
    </message>
    <message>
        <source>Nothing is measured yet.</source>
        <translation>Noch ist nichts gemessen.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ObjectsPanel</name>
    <message>
        <source>preparing</source>
        <translation>wird vorbereitet</translation>
    </message>
    <message>
        <source>not grown</source>
        <translation>nicht gewachsen</translation>
    </message>
    <message>
        <source>no seed</source>
        <translation>kein Startpunkt</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objekte</translation>
    </message>
    <message>
        <source>What the active object is made with</source>
        <translation>Woraus das aktive Objekt gemacht ist</translation>
    </message>
    <message>
        <source>%1, label value %2</source>
        <translation>%1, Labelwert %2</translation>
    </message>
    <message>
        <source>Made with an earlier “%1”</source>
        <translation>Mit einem früheren „%1“ gemacht</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 ausblenden</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Its surface is drawn: hide it</source>
        <translation>Seine Oberfläche wird gezeichnet: ausblenden</translation>
    </message>
    <message>
        <source>Its surface is hidden: show it</source>
        <translation>Seine Oberfläche ist ausgeblendet: zeigen</translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <translation>%1 entsperren</translation>
    </message>
    <message>
        <source>Lock %1</source>
        <translation>%1 sperren</translation>
    </message>
    <message>
        <source>Nothing of it is changed: unlock it</source>
        <translation>An ihm wird nichts geändert: entsperren</translation>
    </message>
    <message>
        <source>Let nothing of it be changed</source>
        <translation>Nichts an ihm ändern lassen</translation>
    </message>
    <message>
        <source>Waits for “%1”, which comes before it and grows.</source>
        <translation>Wartet auf „%1“, das davor kommt und wächst.</translation>
    </message>
    <message>
        <source>Made with an earlier “%1”. Start grows it anew.</source>
        <translation>Mit einem früheren „%1“ gemacht. Start lässt es neu wachsen.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::OpenObjectsDialog</name>
    <message>
        <source>Open objects</source>
        <translation>Objekte öffnen</translation>
    </message>
    <message>
        <source>What are the surfaces of “%1”?</source>
        <translation>Was sind die Oberflächen von „%1“?</translation>
    </message>
    <message>
        <source>Objects that are done stay as they are: locked, written with the others, and walls for objects that grow after them.

Others are where objects begin: they grow from there onto the image, or give ground.</source>
        <translation>Fertige Objekte bleiben, wie sie sind: gesperrt, mit den anderen geschrieben und Wände für Objekte, die danach wachsen.

Mit den anderen beginnen Objekte: Sie wachsen von dort auf das Bild oder geben nach.</translation>
    </message>
    <message>
        <source>Reading the labels…</source>
        <translation>Die Labels werden gelesen…</translation>
    </message>
    <message>
        <source>Segments that overlap</source>
        <translation>Segmente, die sich überlappen</translation>
    </message>
    <message>
        <source>Segments may overlap here: voxels that several of those that are opened hold are left to the smallest of them.</source>
        <translation>Segmente können sich hier überlappen: Voxel, die mehrere der geöffneten enthalten, bleiben dem kleinsten davon.</translation>
    </message>
    <message>
        <source>How the surfaces are made</source>
        <translation>Wie die Oberflächen entstehen</translation>
    </message>
    <message>
        <source>Only the largest &amp;part</source>
        <translation>Nur der größte Te&amp;il</translation>
    </message>
    <message>
        <source>Only the largest part</source>
        <translation>Nur der größte Teil</translation>
    </message>
    <message>
        <source>Of each label only the part with the most voxels: those that share a side</source>
        <translation>Von jedem Label nur der Teil mit den meisten Voxeln: solchen, die eine Seite gemeinsam haben</translation>
    </message>
    <message>
        <source>&amp;Smoothing</source>
        <translation>&amp;Glättung</translation>
    </message>
    <message>
        <source>A voxel along each axis</source>
        <translation>Ein Voxel entlang jeder Achse</translation>
    </message>
    <message>
        <source>A length</source>
        <translation>Eine Länge</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>How far the steps between the voxels are smoothed, as a standard deviation. None: the surface goes midway between the voxels, steps and all.</source>
        <translation>Wie weit die Stufen zwischen den Voxeln geglättet werden, als Standardabweichung. Keine: Die Oberfläche verläuft mitten zwischen den Voxeln, mit allen Stufen.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Length of the smoothing</source>
        <translation>Länge der Glättung</translation>
    </message>
    <message>
        <source>Standard deviation; 0: none, steps and all</source>
        <translation>Standardabweichung; 0: keine, mit allen Stufen</translation>
    </message>
    <message>
        <source>No more &amp;tunnels than</source>
        <translation>Nicht mehr &amp;Tunnel als</translation>
    </message>
    <message>
        <source>No more tunnels than</source>
        <translation>Nicht mehr Tunnel als</translation>
    </message>
    <message>
        <source>In each surface, all of its parts together: tunnels are filled, or what goes around them is cut, whichever changes the fewest voxels</source>
        <translation>In jeder Oberfläche, alle ihre Teile zusammen: Tunnel werden gefüllt, oder was um sie herumführt, wird durchtrennt, je nachdem, was die wenigsten Voxel ändert</translation>
    </message>
    <message>
        <source>Tunnels at most</source>
        <translation>Tunnel höchstens</translation>
    </message>
    <message>
        <source>Tunnels, as in a ring</source>
        <translation>Tunnel, wie in einem Ring</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Fertig</translation>
    </message>
    <message>
        <source>To &amp;grow from</source>
        <translation>Zum &amp;Wachsen</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::OpenPanel</name>
    <message>
        <source>along the patient's axes</source>
        <translation>entlang der Achsen des Patienten</translation>
    </message>
    <message>
        <source>oblique: slices follow the volume's own axes</source>
        <translation>schräg: die Schichten folgen den Achsen des Bildvolumens</translation>
    </message>
    <message>
        <source>Open a CT, MR or ultrasound volume, a DICOM folder or a saved session; files can also be dropped on the window.</source>
        <translation>Öffnen Sie ein CT-, MR- oder Ultraschallvolumen, einen DICOM-Ordner oder eine gespeicherte Sitzung; Dateien lassen sich auch auf dem Fenster ablegen.</translation>
    </message>
    <message>
        <source>Series and stacks: choose one</source>
        <translation>Serien und Stapel: wählen Sie</translation>
    </message>
    <message>
        <source>Open this series</source>
        <translation>Diese Serie öffnen</translation>
    </message>
    <message>
        <source>Open now</source>
        <translation>Jetzt offen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Ausdehnung</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Time point</source>
        <translation>Zeitpunkt</translation>
    </message>
    <message>
        <source>The volume has several time points; one is shown and segmented</source>
        <translation>Das Bildvolumen hat mehrere Zeitpunkte; einer wird gezeigt und segmentiert</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>  (0 to %1)</source>
        <translation>  (0 bis %1)</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::OverTimePanel</name>
    <message>
        <source>grown</source>
        <translation>gewachsen</translation>
    </message>
    <message>
        <source>corrected, from frame %1</source>
        <translation>korrigiert, von Bild %1</translation>
    </message>
    <message>
        <source>carried from frame %1</source>
        <translation>übertragen von Bild %1</translation>
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
        <translation>Bild</translation>
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
        <translation>Zustand</translation>
    </message>
    <message>
        <source>What has become of each frame</source>
        <translation>Was aus jedem Bild wurde</translation>
    </message>
    <message>
        <source>How far the surface is carried</source>
        <translation>Wie weit die Oberfläche übertragen ist</translation>
    </message>
    <message>
        <source>State of what is carried</source>
        <translation>Zustand des Übertragenen</translation>
    </message>
    <message>
        <source>Figures over time</source>
        <translation>Zahlen über die Zeit</translation>
    </message>
    <message>
        <source>held</source>
        <translation>gehalten</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>Topology over time</source>
        <translation>Topologie über die Zeit</translation>
    </message>
    <message>
        <source>Held: no frame has other components or tunnels than the first surface. Free: it may change.</source>
        <translation>Gehalten: Kein Bild hat andere Komponenten oder Tunnel als die erste Oberfläche. Frei: Sie darf sich ändern.</translation>
    </message>
    <message>
        <source>back</source>
        <translation>zurück</translation>
    </message>
    <message>
        <source>round the cycle</source>
        <translation>um den Zyklus</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Check of the way</source>
        <translation>Prüfung des Weges</translation>
    </message>
    <message>
        <source>Back: carried back from the ends, to see how far it is off. Round the cycle: from the last frame to the first, which lie beside each other.</source>
        <translation>Zurück: von den Enden zurückgetragen, um zu sehen, wie weit sie abweicht. Um den Zyklus: vom letzten Bild zum ersten, die nebeneinander liegen.</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Erstes Bild</translation>
    </message>
    <message>
        <source>The surface is carried from here …</source>
        <translation>Die Oberfläche wird von hier …</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Letztes Bild</translation>
    </message>
    <message>
        <source>… to here</source>
        <translation>… bis hier übertragen</translation>
    </message>
    <message>
        <source>Topology</source>
        <translation>Topologie</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Check over time</source>
        <translation>Prüfung über die Zeit</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV…</translation>
    </message>
    <message>
        <source>Plot…</source>
        <translation>Kurve…</translation>
    </message>
    <message>
        <source>Save the curve as CSV</source>
        <translation>Die Kurve als CSV speichern</translation>
    </message>
    <message>
        <source>The same table as “handlebody-cli segment --curve F.csv” writes</source>
        <translation>Dieselbe Tabelle, die „handlebody-cli segment --curve F.csv“ schreibt</translation>
    </message>
    <message>
        <source>Save the curve as a plot</source>
        <translation>Die Kurve als Bild speichern</translation>
    </message>
    <message>
        <source>The same picture (SVG) as “handlebody-cli segment --curve F.svg” writes</source>
        <translation>Dasselbe Bild (SVG), das „handlebody-cli segment --curve F.svg“ schreibt</translation>
    </message>
    <message>
        <source>Meshes…</source>
        <translation>Netze…</translation>
    </message>
    <message>
        <source>Labels…</source>
        <translation>Labels…</translation>
    </message>
    <message>
        <source>Save the volume over time</source>
        <translation>Das Volumen über die Zeit speichern</translation>
    </message>
    <message>
        <source>End-diastole %1 (frame %2), end-systole %3 (frame %4), stroke volume %5, &lt;b&gt;ejection fraction %6 %&lt;/b&gt;.</source>
        <translation>Enddiastole %1 (Bild %2), Endsystole %3 (Bild %4), Schlagvolumen %5, &lt;b&gt;Ejektionsfraktion %6 %&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>From frame %1 back at frame %2: Dice %3, %4 off.</source>
        <translation>Von Bild %1 zurück in Bild %2: Dice %3, Abweichung %4.</translation>
    </message>
    <message>
        <source>The surface was lost on its way from frame %1 back to frame %2.</source>
        <translation>Die Oberfläche ging auf dem Weg von Bild %1 zurück zu Bild %2 verloren.</translation>
    </message>
    <message>
        <source>Frame %1 is being corrected: change it with clicks, walls and edits, then carry on from there.</source>
        <translation>Bild %1 wird korrigiert: Ändern Sie es mit Punkten, Wänden und Bearbeitungen und fahren Sie dann von dort fort.</translation>
    </message>
    <message>
        <source>Carrying the surface through the frames…</source>
        <translation>Die Oberfläche wird durch die Bilder getragen…</translation>
    </message>
    <message>
        <source>These are of an earlier surface of frame %1: carry it anew.</source>
        <translation>Diese gehören zu einer früheren Oberfläche von Bild %1: Tragen Sie sie neu.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::RulersPage</name>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete the chosen ruler or angle</source>
        <translation>Das gewählte Lineal oder den gewählten Winkel löschen</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Begins at (LPS)</source>
        <translation>Beginnt bei (LPS)</translation>
    </message>
    <message>
        <source>Rulers and angles</source>
        <translation>Lineale und Winkel</translation>
    </message>
    <message>
        <source>Places points in the slices or on the surface in 3D. Their ends can be dragged.</source>
        <translation>Setzt Punkte in den Schichten oder auf der Oberfläche in 3D. Ihre Enden lassen sich ziehen.</translation>
    </message>
    <message>
        <source>Click where the ruler begins, or press Return for the crosshair.</source>
        <translation>Klicken Sie, wo das Lineal beginnt, oder drücken Sie die Eingabetaste für das Fadenkreuz.</translation>
    </message>
    <message>
        <source>Click where it ends. Escape takes the beginning back.</source>
        <translation>Klicken Sie, wo sie endet. Escape nimmt den Anfang zurück.</translation>
    </message>
    <message>
        <source>Click the end of one leg, or press Return for the crosshair.</source>
        <translation>Klicken Sie auf das Ende eines Schenkels, oder drücken Sie die Eingabetaste für das Fadenkreuz.</translation>
    </message>
    <message>
        <source>Click where the legs meet. Escape takes the last point back.</source>
        <translation>Klicken Sie, wo sich die Schenkel treffen. Escape nimmt den letzten Punkt zurück.</translation>
    </message>
    <message>
        <source>Click the end of the other leg. Escape takes the last point back.</source>
        <translation>Klicken Sie auf das Ende des anderen Schenkels. Escape nimmt den letzten Punkt zurück.</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Als CSV speichern…</translation>
    </message>
    <message>
        <source>Lengths in mm, angles in degrees and their points (mm, LPS) as a table</source>
        <translation>Längen in mm, Winkel in Grad und ihre Punkte (mm, LPS) als Tabelle</translation>
    </message>
    <message>
        <source>Save as JSON…</source>
        <translation>Als JSON speichern…</translation>
    </message>
    <message>
        <source>The same as “handlebody-cli measure --json” writes of them</source>
        <translation>Dasselbe, was „handlebody-cli measure --json“ davon schreibt</translation>
    </message>
    <message>
        <source>Save the rulers and angles</source>
        <translation>Lineale und Winkel speichern</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SectionPlot</name>
    <message>
        <source>Area and equivalent diameter along the centre line</source>
        <translation>Fläche und äquivalenter Durchmesser entlang der Mittellinie</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Area (mm²)</source>
        <translation>Fläche (mm²)</translation>
    </message>
    <message>
        <source>Equivalent diameter (mm)</source>
        <translation>Äquivalenter Durchmesser (mm)</translation>
    </message>
    <message>
        <source>Area and equivalent diameter are plotted here along the line.</source>
        <translation>Fläche und äquivalenter Durchmesser entlang der Linie werden hier gezeichnet.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SeedPanel</name>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Radius of the selected seed. Automatic: the largest ball that fits into the object; outside of it, as the image allows</source>
        <translation>Radius des gewählten Startpunkts. Automatisch: die größte Kugel, die ins Objekt passt; außerhalb davon, wie das Bild es erlaubt</translation>
    </message>
    <message>
        <source>%1 (auto)</source>
        <translation>%1 (auto)</translation>
    </message>
    <message>
        <source>None yet: it takes a seed inside.</source>
        <translation>Noch keins: ein Startpunkt innerhalb wird gebraucht.</translation>
    </message>
    <message>
        <source>Given by the range in step 3, Tune.</source>
        <translation>Durch den Bereich in Schritt 3, Anpassen, gegeben.</translation>
    </message>
    <message>
        <source>Looking for it…</source>
        <translation>Wird gesucht…</translation>
    </message>
    <message>
        <source>Click into the structure in any slice, then press Return: a ball is placed there, from which the surface grows. One seed is often enough. Shift+Return marks a place outside. Drag a seed to move it, its rim to resize it.</source>
        <translation>Klicken Sie in einer Schicht in die Struktur und drücken Sie die Eingabetaste: dort entsteht eine Kugel, aus der die Oberfläche wächst. Oft genügt ein Startpunkt. Umschalt+Eingabe markiert einen Ort außerhalb. Ziehen Sie einen Startpunkt, um ihn zu verschieben, seinen Rand, um seine Größe zu ändern.</translation>
    </message>
    <message>
        <source>What is wrong with the seeds</source>
        <translation>Was mit den Startpunkten nicht stimmt</translation>
    </message>
    <message>
        <source>Centre (mm LPS)</source>
        <translation>Mittelpunkt (mm LPS)</translation>
    </message>
    <message>
        <source>Radius (mm)</source>
        <translation>Radius (mm)</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Seeds</source>
        <translation>Startpunkte</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außen</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>innen</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SensitivityPage</name>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Volume (ml)</source>
        <translation>Volumen (ml)</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Komponenten</translation>
    </message>
    <message>
        <source>Tunnels</source>
        <translation>Tunnel</translation>
    </message>
    <message>
        <source>Away (mm)</source>
        <translation>Abstand (mm)</translation>
    </message>
    <message>
        <source>The perturbed runs</source>
        <translation>Die veränderten Läufe</translation>
    </message>
    <message>
        <source>Save the perturbed runs</source>
        <translation>Die veränderten Läufe speichern</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Empfindlichkeit</translation>
    </message>
    <message>
        <source>Grow the surface several times again, with clicks, smoothing and noise a little different: how much do volume and surface change?</source>
        <translation>Die Oberfläche noch mehrmals wachsen lassen, mit etwas anderen Punkten, Glättung und Rauschen: Wie sehr ändern sich Volumen und Oberfläche?</translation>
    </message>
    <message>
        <source> runs</source>
        <translation> Läufe</translation>
    </message>
    <message>
        <source>Number of runs</source>
        <translation>Zahl der Läufe</translation>
    </message>
    <message>
        <source>How often it is grown again; each takes about as long as the growth</source>
        <translation>Wie oft sie neu wächst; jedes Mal dauert etwa so lange wie das Wachstum</translation>
    </message>
    <message>
        <source>Volume with its spread</source>
        <translation>Volumen mit seiner Streuung</translation>
    </message>
    <message>
        <source>State of the sensitivity</source>
        <translation>Zustand der Empfindlichkeit</translation>
    </message>
    <message>
        <source>How far it moves, in colour on the surface</source>
        <translation>Wie weit sie sich bewegt, in Farbe auf der Oberfläche</translation>
    </message>
    <message>
        <source>White where the surface is certain, red where it moves from run to run</source>
        <translation>Weiß, wo die Oberfläche sicher ist, rot, wo sie sich von Lauf zu Lauf bewegt</translation>
    </message>
    <message>
        <source>How many runs have ended</source>
        <translation>Wie viele Läufe zu Ende sind</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Als CSV speichern…</translation>
    </message>
    <message>
        <source>Save the runs as CSV</source>
        <translation>Die Läufe als CSV speichern</translation>
    </message>
    <message>
        <source>Volume, topology and distance of every run</source>
        <translation>Volumen, Topologie und Abstand jedes Laufs</translation>
    </message>
    <message>
        <source>moves by</source>
        <translation>bewegt sich um</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1 ± %2 ml</source>
        <translation>%1 ± %2 ml</translation>
    </message>
    <message>
        <source>%1 to %2 in %3 of %4 runs, %5 of the same topology. The surface moves by %6, 95 % of it by less than %7.</source>
        <translation>%1 bis %2 in %3 von %4 Läufen, %5 mit derselben Topologie. Die Oberfläche bewegt sich um %6, 95 % davon um weniger als %7.</translation>
    </message>
    <message>
        <source> ⚠ %1.</source>
        <translation> ⚠ %1.</translation>
    </message>
    <message>
        <source>None of the runs left a surface.</source>
        <translation>Keiner der Läufe ließ eine Oberfläche übrig.</translation>
    </message>
    <message>
        <source>Growing it again…</source>
        <translation>Sie wächst neu…</translation>
    </message>
    <message>
        <source>These are figures of an earlier surface, or of another object.</source>
        <translation>Dies sind Kennzahlen einer früheren Oberfläche oder eines anderen Objekts.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SeriesList</name>
    <message>
        <source>, stack %1</source>
        <translation>, Stapel %1</translation>
    </message>
    <message>
        <source>No volume: %1</source>
        <translation>Kein Bildvolumen: %1</translation>
    </message>
    <message>
        <source>%1, %2 mm</source>
        <translation>%1, %2 mm</translation>
    </message>
    <message>
        <source>Slices: %1</source>
        <translation>Schichten: %1</translation>
    </message>
    <message>
        <source>Files: %1</source>
        <translation>Dateien: %1</translation>
    </message>
    <message>
        <source> · time points: %1</source>
        <translation> · Zeitpunkte: %1</translation>
    </message>
    <message>
        <source>Series in the folder</source>
        <translation>Serien im Ordner</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SliceView</name>
    <message>
        <source>%1, oblique</source>
        <translation>%1, schräg</translation>
    </message>
    <message>
        <source>W %1  L %2</source>
        <translation>F %1  L %2</translation>
    </message>
    <message>
        <source>no edge in the image</source>
        <translation>keine Kante im Bild</translation>
    </message>
    <message>
        <source>pinned</source>
        <translation>fixiert</translation>
    </message>
    <message>
        <source>Open a volume: Ctrl+O,
or drop a file here</source>
        <translation>Bildvolumen öffnen: Strg+O,
oder eine Datei hier ablegen</translation>
    </message>
    <message>
        <source>%1 slice</source>
        <translation>Schicht %1</translation>
    </message>
    <message>
        <source>Arrows and Page Up or Down move the crosshair, Return adds a seed, Shift and Return a click outside of the object, W changes window and level. B and E turn the brush for walls on and off, with Shift they paint and erase at the crosshair; L pins with it, Shift and L unpins, M smooths, U pulls.</source>
        <translation>Pfeile und Bild auf oder ab bewegen das Fadenkreuz, Eingabe setzt einen Startpunkt, Umschalt und Eingabe einen Außenpunkt, W ändert die Fensterung. B und E schalten den Pinsel für Wände an und aus, mit Umschalt malen und radieren sie am Fadenkreuz; L fixiert damit, Umschalt und L löst, M glättet, U zieht.</translation>
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
        <translation>Abstand der Mitten benachbarter Voxel</translation>
    </message>
    <message>
        <source>Size of a voxel</source>
        <translation>Größe eines Voxels</translation>
    </message>
    <message>
        <source>The file does not give it. Lengths and volumes are right only with the true spacing along columns, rows and slices.</source>
        <translation>Die Datei gibt sie nicht an. Längen und Volumen stimmen nur mit dem wahren Abstand entlang der Spalten, Zeilen und Schichten.</translation>
    </message>
    <message>
        <source>Spacing of columns</source>
        <translation>Abstand der Spalten</translation>
    </message>
    <message>
        <source>Spacing of rows</source>
        <translation>Abstand der Zeilen</translation>
    </message>
    <message>
        <source>Spacing of slices</source>
        <translation>Abstand der Schichten</translation>
    </message>
    <message>
        <source>Open with this spacing</source>
        <translation>Mit diesem Abstand öffnen</translation>
    </message>
    <message>
        <source>File without a spacing</source>
        <translation>Datei ohne Voxelabstand</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::StartPage</name>
    <message>
        <source>Open a volume to begin</source>
        <translation>Öffnen Sie ein Bildvolumen</translation>
    </message>
    <message>
        <source>Drop a CT, MR or ultrasound volume here, or choose one.</source>
        <translation>Legen Sie hier ein CT-, MR- oder Ultraschallvolumen ab, oder wählen Sie eines.</translation>
    </message>
    <message>
        <source>Try the ultrasound sample</source>
        <translation>Das Ultraschallbeispiel ausprobieren</translation>
    </message>
    <message>
        <source>A simulated cyst with a needle through it, with its seed placed</source>
        <translation>Eine simulierte Zyste mit einer Nadel hindurch, mit gesetztem Startpunkt</translation>
    </message>
    <message>
        <source>Opened before</source>
        <translation>Früher geöffnet</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::StatusFields</name>
    <message>
        <source>Position of the mouse, mm LPS</source>
        <translation>Ort der Maus, mm LPS</translation>
    </message>
    <message>
        <source>Voxel under the mouse</source>
        <translation>Voxel unter der Maus</translation>
    </message>
    <message>
        <source>Voxel %1</source>
        <translation>Voxel %1</translation>
    </message>
    <message>
        <source>Intensity of the voxel</source>
        <translation>Intensität des Voxels</translation>
    </message>
    <message>
        <source>Intensity %1</source>
        <translation>Intensität %1</translation>
    </message>
    <message>
        <source>Uncalibrated</source>
        <translation>Nicht kalibriert</translation>
    </message>
    <message>
        <source>State of the growth</source>
        <translation>Stand des Wachstums</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop reading the volume; what is open stays open</source>
        <translation>Das Lesen des Bildvolumens abbrechen; was offen ist, bleibt offen</translation>
    </message>
    <message>
        <source>The file does not give the size of a voxel: lengths, areas and volumes mean nothing until it is entered in step 1, Open</source>
        <translation>Die Datei gibt die Größe eines Voxels nicht an: Längen, Flächen und Volumen bedeuten nichts, bis sie in Schritt 1, Öffnen, eingegeben ist</translation>
    </message>
    <message>
        <source>Nothing is open</source>
        <translation>Nichts ist geöffnet</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>%1 wird gelesen…</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::StepsPanel</name>
    <message>
        <source>Step %1</source>
        <translation>Schritt %1</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SurfaceView</name>
    <message>
        <source>This machine offers no OpenGL 3.2: the surface cannot be shown in 3D. Slices, growth and export work all the same.</source>
        <translation>Dieser Rechner bietet kein OpenGL 3.2: die Oberfläche kann nicht in 3D gezeigt werden. Schichten, Wachstum und Export gehen trotzdem.</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>The surface grows here</source>
        <translation>Hier wächst die Oberfläche</translation>
    </message>
    <message>
        <source>Nothing is left of the surface</source>
        <translation>Von der Oberfläche ist nichts übrig</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Home, End and Page Down look from superior, anterior and left. With the brush on, left pins, unpins, smooths or pulls the surface.</source>
        <translation>Pos1, Ende und Bild ab blicken von oben, vorn und links. Bei eingeschaltetem Pinsel fixiert, löst, glättet oder zieht die linke Taste die Oberfläche.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TimeBar</name>
    <message>
        <source>Frame %1 of 0–%2</source>
        <translation>Bild %1 von 0–%2</translation>
    </message>
    <message>
        <source>%1, %2 ms</source>
        <translation>%1, %2 ms</translation>
    </message>
    <message>
        <source>Shown frame</source>
        <translation>Gezeigtes Bild</translation>
    </message>
    <message>
        <source>What is wrong with the shown frame</source>
        <translation>Was am gezeigten Bild nicht stimmt</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen…</translation>
    </message>
    <message>
        <source>The surface is grown in this frame</source>
        <translation>In diesem Bild ist die Oberfläche gewachsen</translation>
    </message>
    <message>
        <source>The surface has not been carried here</source>
        <translation>Die Oberfläche wurde nicht hierher übertragen</translation>
    </message>
    <message>
        <source>The surface here was carried from an earlier state of frame %1: carry it again.</source>
        <translation>Die Oberfläche hier wurde von einem früheren Stand von Bild %1 getragen: Tragen Sie sie noch einmal.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TimelinePanel</name>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Changes of topology are listed here.</source>
        <translation>Änderungen der Topologie stehen hier.</translation>
    </message>
    <message>
        <source>Show repairs of the mesh, too</source>
        <translation>Auch Reparaturen des Netzes zeigen</translation>
    </message>
    <message>
        <source>&lt;p&gt;Folds that were smoothed away, and parts of the surface whose step would have left an invalid mesh and that returned to where they were. The topology is the same before and after.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Falten, die geglättet wurden, und Teile der Oberfläche, deren Schritt ein ungültiges Netz hinterlassen hätte und die zurückkehrten. Die Topologie ist davor und danach dieselbe.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TimelinePlot</name>
    <message>
        <source>Leak: %1</source>
        <translation>Leck: %1</translation>
    </message>
    <message>
        <source>Volume and moving share over the iterations</source>
        <translation>Volumen und bewegter Anteil über die Iterationen</translation>
    </message>
    <message>
        <source>Iteration %1: %2, %3 % of the vertices moving, %4</source>
        <translation>Iteration %1: %2, %3 % der Ecken in Bewegung, %4</translation>
    </message>
    <message>
        <source>events: %1</source>
        <translation>Ereignisse: %1</translation>
    </message>
    <message>
        <source>Volume, up to %1</source>
        <translation>Volumen, bis %1</translation>
    </message>
    <message>
        <source>Moving, 0 to 100 %</source>
        <translation>Bewegt, 0 bis 100 %</translation>
    </message>
    <message>
        <source>Volume and motion are plotted here while the surface grows.</source>
        <translation>Volumen und Bewegung werden hier gezeichnet, während die Oberfläche wächst.</translation>
    </message>
    <message>
        <source>Changed at %1: %2</source>
        <translation>Geändert bei %1: %2</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TimelineSlider</name>
    <message>
        <source>Iteration</source>
        <translation>Iteration</translation>
    </message>
    <message>
        <source>&lt;p&gt;Iterations; diamonds are changes of topology, strokes below the line places that were rolled back. Click or drag to go there.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Iterationen; Rauten sind Änderungen der Topologie, Striche unter der Linie Stellen, die zurückgenommen wurden. Klicken oder ziehen, um dorthin zu gehen.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TopologySection</name>
    <message>
        <source>Held at iteration %1: %2.</source>
        <translation>Gehalten bei Iteration %1: %2.</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>Topology</source>
        <translation>Topologie</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Never more than</source>
        <translation>Nie mehr als</translation>
    </message>
    <message>
        <source>Ask each time</source>
        <translation>Jedes Mal fragen</translation>
    </message>
    <message>
        <source>What happens where the surface would get more parts or tunnels than are chosen: it gets them, never does (what is held is listed in Correct), or the growth pauses and asks you</source>
        <translation>Was geschieht, wo die Oberfläche mehr Teile oder Tunnel bekäme, als gewählt sind: Sie bekommt sie, bekommt sie nie (was gehalten wird, steht unter Korrektur), oder das Wachstum hält an und fragt Sie</translation>
    </message>
    <message>
        <source>Components at most</source>
        <translation>Komponenten höchstens</translation>
    </message>
    <message>
        <source>Connected parts of the surface, cavities included</source>
        <translation>Zusammenhängende Teile der Oberfläche, Hohlräume eingeschlossen</translation>
    </message>
    <message>
        <source>Genus at most</source>
        <translation>Geschlecht höchstens</translation>
    </message>
    <message>
        <source>Tunnels, as in a ring, of all parts together</source>
        <translation>Tunnel, wie in einem Ring, aller Teile zusammen</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>Geschlecht</translation>
    </message>
    <message>
        <source>To decide</source>
        <translation>Zu entscheiden</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>Zulassen</translation>
    </message>
    <message>
        <source>It may break the limits here; the growth goes on</source>
        <translation>Sie darf die Grenzen hier überschreiten; das Wachstum geht weiter</translation>
    </message>
    <message>
        <source>Hold it</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>It stays held here, and you are not asked again; the growth goes on</source>
        <translation>Es bleibt hier gehalten, und Sie werden nicht erneut gefragt; das Wachstum geht weiter</translation>
    </message>
    <message>
        <source>Free topology</source>
        <translation>Topologie freigeben</translation>
    </message>
    <message>
        <source>Ask about the topology</source>
        <translation>Nach der Topologie fragen</translation>
    </message>
    <message>
        <source>Limit the topology</source>
        <translation>Topologie begrenzen</translation>
    </message>
    <message>
        <source>%1 more to decide.</source>
        <translation>Noch %1 zu entscheiden.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TouchSection</name>
    <message>
        <source>Pin</source>
        <translation>Fixieren</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Cut line</source>
        <translation>Linie schneiden</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Number of pins</source>
        <translation>Anzahl der Fixierungen</translation>
    </message>
    <message>
        <source>Nothing is pinned.</source>
        <translation>Nichts ist fixiert.</translation>
    </message>
    <message>
        <source>Balls pinned: %1</source>
        <translation>Fixierte Kugeln: %1</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TunePanel</name>
    <message>
        <source>What is wrong with the parameters</source>
        <translation>Was mit den Parametern nicht stimmt</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Bright</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>The object is darker than its surroundings</source>
        <translation>Das Objekt ist dunkler als seine Umgebung</translation>
    </message>
    <message>
        <source>The object is brighter than its surroundings</source>
        <translation>Das Objekt ist heller als seine Umgebung</translation>
    </message>
    <message>
        <source>Found out from the image around the seeds</source>
        <translation>Aus dem Bild um die Startpunkte ermittelt</translation>
    </message>
    <message>
        <source>Change object</source>
        <translation>Objekt ändern</translation>
    </message>
    <message>
        <source>Intensities from the lower to the upper end belong to the object</source>
        <translation>Intensitäten vom unteren bis zum oberen Ende gehören zum Objekt</translation>
    </message>
    <message>
        <source>Intensities of the object</source>
        <translation>Intensitäten des Objekts</translation>
    </message>
    <message>
        <source>Lowest intensity of the object</source>
        <translation>Kleinste Intensität des Objekts</translation>
    </message>
    <message>
        <source>Highest intensity of the object</source>
        <translation>Größte Intensität des Objekts</translation>
    </message>
    <message>
        <source>Range: automatic</source>
        <translation>Bereich: automatisch</translation>
    </message>
    <message>
        <source>Chosen from the image around the seeds</source>
        <translation>Aus dem Bild um die Startpunkte gewählt</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Change range</source>
        <translation>Bereich ändern</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Change smoothing</source>
        <translation>Glättung ändern</translation>
    </message>
    <message>
        <source>Change edge length</source>
        <translation>Kantenlänge ändern</translation>
    </message>
    <message>
        <source>Change balloon</source>
        <translation>Ballon ändern</translation>
    </message>
    <message>
        <source>Change curvature</source>
        <translation>Krümmung ändern</translation>
    </message>
    <message>
        <source>Change iteration limit</source>
        <translation>Iterationsgrenze ändern</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Outward</source>
        <translation>Auswärts</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>The surface only grows</source>
        <translation>Die Oberfläche wächst nur</translation>
    </message>
    <message>
        <source>The surface may also shrink</source>
        <translation>Die Oberfläche darf auch schrumpfen</translation>
    </message>
    <message>
        <source>Change direction</source>
        <translation>Richtung ändern</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Experten</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>Kollisionen</translation>
    </message>
    <message>
        <source>Sorted</source>
        <translation>Sortiert</translation>
    </message>
    <message>
        <source>Hashing</source>
        <translation>Hash</translation>
    </message>
    <message>
        <source>Near vertices are found in one sorted table. The surface does not depend on it</source>
        <translation>Nahe Ecken werden in einer sortierten Tabelle gefunden. Die Oberfläche hängt nicht davon ab</translation>
    </message>
    <message>
        <source>Near vertices are found by the paper's eight hash functions: slower, the same surface</source>
        <translation>Nahe Ecken werden mit den acht Hashfunktionen des Artikels gefunden: langsamer, dieselbe Oberfläche</translation>
    </message>
    <message>
        <source>Change search for collisions</source>
        <translation>Suche nach Kollisionen ändern</translation>
    </message>
    <message>
        <source>%1 everything here is then chosen from the image. Change it only if the surface leaks or stops early.</source>
        <translation>%1 alles hier wird dann aus dem Bild gewählt. Ändern Sie es nur, wenn die Oberfläche ausläuft oder früh anhält.</translation>
    </message>
    <message>
        <source>Place a seed:</source>
        <translation>Setzen Sie einen Startpunkt:</translation>
    </message>
    <message>
        <source>Open a volume and place a seed:</source>
        <translation>Öffnen Sie ein Bildvolumen und setzen Sie einen Startpunkt:</translation>
    </message>
    <message>
        <source>Auto (dark)</source>
        <translation>Auto (dunkel)</translation>
    </message>
    <message>
        <source>Auto (bright)</source>
        <translation>Auto (hell)</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Adaptive</source>
        <translation>Angepasst</translation>
    </message>
    <message>
        <source>The target edge length is the same everywhere</source>
        <translation>Die Ziel-Kantenlänge ist überall gleich</translation>
    </message>
    <message>
        <source>Edges and steps are up to four times as long where the image shows no boundary near by: fewer iterations</source>
        <translation>Kanten und Schritte sind bis zu viermal so lang, wo das Bild keine Grenze in der Nähe zeigt: weniger Iterationen</translation>
    </message>
    <message>
        <source>Change edges</source>
        <translation>Kanten ändern</translation>
    </message>
    <message>
        <source>Tint the object in the slices</source>
        <translation>Objekt in den Schichten tönen</translation>
    </message>
    <message>
        <source>The voxels that the surface is driven into: as smoothed, up to necks that are cut and to walls. They are tinted for a moment after every change; with this on, all the time</source>
        <translation>Die Voxel, in die die Oberfläche getrieben wird: geglättet, bis zu durchtrennten Engstellen und zu Wänden. Sie werden nach jeder Änderung kurz getönt; hiermit immer</translation>
    </message>
    <message>
        <source>Adaptive where the object is wide for its edges, so that this saves iterations</source>
        <translation>Adaptiv, wo das Objekt für seine Kanten so breit ist, dass dies Iterationen spart</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TunnelsList</name>
    <message>
        <source>Component removed</source>
        <translation>Komponente entfernt</translation>
    </message>
    <message>
        <source>One component kept</source>
        <translation>Eine Komponente behalten</translation>
    </message>
    <message>
        <source>Cavity filled</source>
        <translation>Hohlraum gefüllt</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>Geglättet</translation>
    </message>
    <message>
        <source>Pulled</source>
        <translation>Gezogen</translation>
    </message>
    <message>
        <source>Cut by a plane</source>
        <translation>Mit einer Ebene geschnitten</translation>
    </message>
    <message>
        <source>Handle cut</source>
        <translation>Henkel durchschnitten</translation>
    </message>
    <message>
        <source>Tunnel filled</source>
        <translation>Tunnel gefüllt</translation>
    </message>
    <message>
        <source>Tunnel closed</source>
        <translation>Tunnel geschlossen</translation>
    </message>
    <message>
        <source>What the surface holds</source>
        <translation>Was die Oberfläche enthält</translation>
    </message>
    <message>
        <source>The chosen row</source>
        <translation>Die gewählte Zeile</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Tunnels, components and cavities, each with its size</source>
        <translation>Tunnel, Komponenten und Hohlräume, jeweils mit Größe</translation>
    </message>
    <message>
        <source>Cut handle</source>
        <translation>Henkel durchschneiden</translation>
    </message>
    <message>
        <source>Cuts along the loop around the handle, which goes; both ends get a cap</source>
        <translation>Schneidet entlang der Schleife um den Henkel, der verschwindet; beide Enden bekommen einen Deckel</translation>
    </message>
    <message>
        <source>Fill tunnel</source>
        <translation>Tunnel füllen</translation>
    </message>
    <message>
        <source>Cuts along the loop round the tunnel: a membrane closes it on both sides</source>
        <translation>Schneidet entlang der Schleife um den Tunnel: eine Membran schließt ihn auf beiden Seiten</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes this component with all that lies in it</source>
        <translation>Entfernt diese Komponente mit allem, was darin liegt</translation>
    </message>
    <message>
        <source>Keep only this</source>
        <translation>Nur dies behalten</translation>
    </message>
    <message>
        <source>Removes everything but this component and its cavities</source>
        <translation>Entfernt alles außer dieser Komponente und ihren Hohlräumen</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllen</translation>
    </message>
    <message>
        <source>Fills this cavity, with all that lies in it</source>
        <translation>Füllt diesen Hohlraum mit allem, was darin liegt</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>Goes back to the step before this edit, and on without it</source>
        <translation>Geht zurück zum Schritt vor dieser Bearbeitung und ohne sie weiter</translation>
    </message>
    <message>
        <source>Tunnel</source>
        <translation>Tunnel</translation>
    </message>
    <message>
        <source>%1 around its handle, %2 round the tunnel</source>
        <translation>%1 um den Henkel, %2 um den Tunnel</translation>
    </message>
    <message>
        <source>; knotted</source>
        <translation>; verknotet</translation>
    </message>
    <message>
        <source>Cavity</source>
        <translation>Hohlraum</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>Komponente</translation>
    </message>
    <message>
        <source>%1 mm, genus %2</source>
        <translation>%1 mm, Geschlecht %2</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>At %1</source>
        <translation>Bei %1</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>Wird gesucht…</translation>
    </message>
    <message>
        <source>Tunnels: %1</source>
        <translation>Tunnel: %1</translation>
    </message>
    <message>
        <source>components: %1</source>
        <translation>Komponenten: %1</translation>
    </message>
    <message>
        <source>cavities: %1</source>
        <translation>Hohlräume: %1</translation>
    </message>
    <message>
        <source>tunnels without loops: %1</source>
        <translation>Tunnel ohne Schleifen: %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Find tunnels and pieces</source>
        <translation>Tunnel und Teile suchen</translation>
    </message>
    <message>
        <source>Lists the tunnels, components and cavities of the shown surface</source>
        <translation>Listet Tunnel, Komponenten und Hohlräume der gezeigten Oberfläche</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ValueField</name>
    <message>
        <source>Reset %1</source>
        <translation>%1 zurücksetzen</translation>
    </message>
    <message>
        <source>Back to the usual value, %1</source>
        <translation>Zurück zum üblichen Wert, %1</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>%1: automatic</source>
        <translation>%1: automatisch</translation>
    </message>
    <message>
        <source>The value is chosen from the image around the seeds</source>
        <translation>Der Wert wird aus dem Bild um die Startpunkte gewählt</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ViewFrame</name>
    <message>
        <source>Show all four views (double click)</source>
        <translation>Alle vier Ansichten zeigen (Doppelklick)</translation>
    </message>
    <message>
        <source>Let this view fill the window (double click)</source>
        <translation>Diese Ansicht füllt das Fenster (Doppelklick)</translation>
    </message>
    <message>
        <source>Show all four views</source>
        <translation>Alle vier Ansichten zeigen</translation>
    </message>
    <message>
        <source>Maximise the %1 view</source>
        <translation>Ansicht %1 maximieren</translation>
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
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>%1 view</source>
        <translation>Ansicht %1</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::VolumePlot</name>
    <message>
        <source>Volume over time</source>
        <translation>Volumen über die Zeit</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Volume (ml) over time (ms)</source>
        <translation>Volumen (ml) über die Zeit (ms)</translation>
    </message>
    <message>
        <source>Volume (ml) over frames</source>
        <translation>Volumen (ml) über die Bilder</translation>
    </message>
    <message>
        <source>end-diastole</source>
        <translation>Enddiastole</translation>
    </message>
    <message>
        <source>end-systole</source>
        <translation>Endsystole</translation>
    </message>
    <message>
        <source>The volume over time is plotted here when the surface is carried through the frames.</source>
        <translation>Das Volumen über die Zeit wird hier gezeichnet, wenn die Oberfläche durch die Bilder getragen wird.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::WallSection</name>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Number of walls</source>
        <translation>Anzahl der Wände</translation>
    </message>
    <message>
        <source>Nothing is painted.</source>
        <translation>Nichts ist gemalt.</translation>
    </message>
    <message>
        <source>Balls painted: %1</source>
        <translation>Gemalte Kugeln: %1</translation>
    </message>
</context>
</TS>
